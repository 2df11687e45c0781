#!/usr/bin/env bash
# libccd 2.1 (Debian 12: libccd-dev 2.1-2+b1), contacts of convex grains from their support functions: the depth of overlap of two
# spheres, and of two cubes, by the sum of their half widths less their distance.
#
# Guess: the depth is right to a ten-thousandth of itself (epa_tolerance and mpr_tolerance are 1e-4), whatever the unit.
# Seen: these are lengths. Of spheres of radius 1 ccdGJKPenetration finds an overlap of 0.1 3% too small, one of 1e-4 is 3% of
# itself. At a radius of 0.001 neither spheres nor cubes that overlap by a tenth touch, and cubes with a gap of a thousandth of
# their size do; at 1e-6 all touch, up to thousands of times too deep. No error of any. ccdMPRPenetration is right for these spheres,
# and for the cubes down to 0.001. Take diameters for the unit, MPR, and closed forms where there are any.
#   depth over true depth for overlaps of 0.1 and 1e-4 of the radius, and for a gap of 0.001 of it
#   spheres of radius 1: GJK 0.97, 0.032, apart; MPR 1, 1, apart
#   spheres of radius 0.001: GJK apart, apart, apart; MPR 1, 1, apart
#   spheres of radius 1e-06: GJK 2.3, 3.2e+03, in touch; MPR 1, 1, apart
#   cubes of radius 1: GJK 1, 1, apart; MPR 1, 1, apart
#   cubes of radius 0.001: GJK apart, apart, in touch; MPR 1, 1, apart
#   cubes of radius 1e-06: GJK 2.3, 2.1e+03, in touch; MPR 17, 1.7e+04, in touch
set -euo pipefail
want=2.1-2+b1
version=$(dpkg-query -W -f='${Version}' libccd-dev 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs libccd-dev $want, found '${version:-none}'"; exit 77; }
command -v gcc >/dev/null || { echo "needs gcc"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > depth.c <<'C'
#include <ccd/ccd.h>
#include <math.h>
#include <stdio.h>

struct grain {
  ccd_vec3_t centre;
  double radius;  // half the width of a cube
  int is_cube;
};

static void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* corner) {
  const struct grain* grain = object;
  double length = sqrt(ccdVec3Len2(direction));
  for (int i = 0; i < 3; ++i) {
    double along = direction->v[i];
    double part = grain->is_cube ? (along < 0 ? -1 : 1) : along / length;
    corner->v[i] = grain->centre.v[i] + grain->radius * part;
  }
}

static void centre(const void* object, ccd_vec3_t* point) { *point = ((const struct grain*)object)->centre; }

static void print_depth(int is_mpr, int is_cube, double radius, double share) {  // overlap by that share of the radius
  double distance = (2 - share) * radius, turn = is_cube ? 0 : 0.3;
  struct grain a = {{{0, 0, 0}}, radius, is_cube};
  struct grain b = {{{distance * cos(turn), is_cube ? 0.3 * radius : distance * sin(turn), 0}}, radius, is_cube};
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support;
  ccd.center1 = ccd.center2 = centre;
  ccd.max_iterations = 1000;
  ccd_real_t depth;
  ccd_vec3_t direction, place;
  int is_apart = (is_mpr ? ccdMPRPenetration : ccdGJKPenetration)(&a, &b, &ccd, &depth, &direction, &place);
  if (is_apart) printf("apart");
  else if (share < 0) printf("in touch");
  else printf("%.2g", depth / (share * radius));
}

int main(void) {
  double radii[] = {1, 1e-3, 1e-6}, shares[] = {0.1, 1e-4, -1e-3};
  for (int is_cube = 0; is_cube < 2; ++is_cube)
    for (int i = 0; i < 3; ++i) {
      printf("%s of radius %g:", is_cube ? "cubes" : "spheres", radii[i]);
      for (int is_mpr = 0; is_mpr < 2; ++is_mpr)
        for (int j = 0; j < 3; ++j) {
          printf(j ? ", " : is_mpr ? "; MPR " : " GJK ");
          print_depth(is_mpr, is_cube, radii[i], shares[j]);
        }
      printf("\n");
    }
}
C
gcc -O0 depth.c -o depth -lccd -lm
./depth > seen
cat seen
diff seen - <<'SEEN'
spheres of radius 1: GJK 0.97, 0.032, apart; MPR 1, 1, apart
spheres of radius 0.001: GJK apart, apart, apart; MPR 1, 1, apart
spheres of radius 1e-06: GJK 2.3, 3.2e+03, in touch; MPR 1, 1, apart
cubes of radius 1: GJK 1, 1, apart; MPR 1, 1, apart
cubes of radius 0.001: GJK apart, apart, in touch; MPR 1, 1, apart
cubes of radius 1e-06: GJK 2.3, 2.1e+03, in touch; MPR 17, 1.7e+04, in touch
SEEN
