#!/usr/bin/env bash
# dsp.js 1.0.1 (npm): the stress of large oscillatory shear, ten cycles in one second of 256 points: mean 3, first harmonic 2,
# third 0.5. Its classes FFT, RFFT (for real numbers) and DFT have the same properties.
#
# Guess: amplitudes 3, 2 and 0.5 at the bands 0, 10 and 30, whose frequencies are 0, 10 and 30, by all three.
# Seen: RFFT has each harmonic one band too low, 9 and 29: at three times the band of the first, 27, there is nothing, so that
# the response seems linear. All have the mean doubled, 6, so that it counts as the peak. getBandFrequency adds half a band: the
# 10 Hz of the drive are 10.5, with RFFT 9.5. No word of it. Take FFT, the number of the band times bandwidth, and half of band 0.
#   FFT: 6.000 in band 0, 2.000 in band 10, 0.500 in band 30; frequency of band 10: 10.5; third harmonic by the number of the band 0.500
#   DFT: 6.000 in band 0, 2.000 in band 10, 0.500 in band 30; frequency of band 10: 10.5; third harmonic by the number of the band 0.500
#   RFFT: 6.000 in band 0, 2.000 in band 9, 0.500 in band 29; frequency of band 9: 9.5; third harmonic by the number of the band 0.000
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . dsp.js@1.0.1 >/dev/null
cat > harmonics.cjs <<'NODE'
const dsp = require('dsp.js');
const points = 256;
const phase = (i) => (2 * Math.PI * 10 * i) / points;
const stress = Float64Array.from({ length: points }, (_, i) => 3 + 2 * Math.sin(phase(i)) + 0.5 * Math.sin(3 * phase(i)));
for (const name of ['FFT', 'DFT', 'RFFT']) {
  const transform = new dsp[name](points, points);
  transform.forward(stress);
  const bands = Array.from(transform.spectrum, (amplitude, band) => ({ amplitude, band })).filter((each) => each.amplitude > 0.01);
  const drive = bands.find(({ band }) => band > 0).band;
  console.log(`${name}: ${bands.map(({ amplitude, band }) => `${amplitude.toFixed(3)} in band ${band}`).join(', ')}; ` +
    `frequency of band ${drive}: ${transform.getBandFrequency(drive)}; third harmonic by the number of the band ` +
    `${Math.abs(transform.spectrum[3 * drive]).toFixed(3)}`);
}
NODE
node harmonics.cjs > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
FFT: 6.000 in band 0, 2.000 in band 10, 0.500 in band 30; frequency of band 10: 10.5; third harmonic by the number of the band 0.500
DFT: 6.000 in band 0, 2.000 in band 10, 0.500 in band 30; frequency of band 10: 10.5; third harmonic by the number of the band 0.500
RFFT: 6.000 in band 0, 2.000 in band 9, 0.500 in band 29; frequency of band 9: 9.5; third harmonic by the number of the band 0.000
SEEN
