#!/usr/bin/env bash
# @iarna/toml 3.0.0 and smol-toml 1.9.1 (npm): reading a case in TOML, such as those of simulations, and writing it again.
#
# Guess: what is written is read again with the same numbers and types.
# Seen: @iarna/toml writes 1e-7 as `1e-7.undefined`, which no reader takes, its own neither: each number below 1e-6 that is a
# power of ten or has one digit. 1.5e-7 is fine. Both write the float 1.0 as the integer 1 and 1e3 as 1000, so a reader that
# tells floats from integers refuses what it gave them; and a list of floats becomes one of both kinds. smol-toml reads no
# integer beyond 2^53. Write cases as text, not from numbers.
#   @iarna/toml: radius = 1 | time_step = 1e-7.undefined | gap = 1.5e-7 | widths = [ 1, 2.5 ] | read again: TomlError
#   smol-toml: radius = 1 | time_step = 1e-7 | gap = 1.5e-7 | widths = [ 1, 2.5 ] | read again: the same
#   seed = 9007199254740993: @iarna/toml 9007199254740993, smol-toml TomlError
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . @iarna/toml@3.0.0 smol-toml@1.9.1 >/dev/null
cat > write.mjs <<'NODE'
import iarna from '@iarna/toml';
import * as smol from 'smol-toml';
const attempt = (what) => {
  try {
    return what();
  } catch (error) {
    return error.constructor.name;
  }
};
const text = 'radius = 1.0\ntime_step = 1e-7\ngap = 1.5e-7\nwidths = [1.0, 2.5]\n';
for (const [name, toml] of [['@iarna/toml', iarna], ['smol-toml', smol]]) {
  const written = toml.stringify(toml.parse(text)).trim();
  const again = attempt(() => (JSON.stringify(toml.parse(written)) === JSON.stringify(toml.parse(text)) ? 'the same' : 'other'));
  console.log(`${name}: ${written.replaceAll('\n', ' | ')} | read again: ${again}`);
}
const seed = (toml) => attempt(() => toml.parse('seed = 9007199254740993').seed);
console.log(`seed = 9007199254740993: @iarna/toml ${seed(iarna)}, smol-toml ${seed(smol)}`);
NODE
node write.mjs > seen
cat seen
diff seen - <<'SEEN'
@iarna/toml: radius = 1 | time_step = 1e-7.undefined | gap = 1.5e-7 | widths = [ 1, 2.5 ] | read again: TomlError
smol-toml: radius = 1 | time_step = 1e-7 | gap = 1.5e-7 | widths = [ 1, 2.5 ] | read again: the same
seed = 9007199254740993: @iarna/toml 9007199254740993, smol-toml TomlError
SEEN
