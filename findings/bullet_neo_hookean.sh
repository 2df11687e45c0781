#!/usr/bin/env bash
# Bullet 3.24 (Debian 12: libbullet-dev 3.24+dfsg-2, compiled by g++), the three laws for deformable bodies of tetrahedra, each
# for a material with a Young's modulus of 150 and some Poisson's ratio: btDeformableNeoHookeanForce, which has setYoungsModulus
# and setPoissonRatio for it, btDeformableCorotatedForce and btDeformableLinearElasticityForce. What the material is like, by the
# forces on the corners of one tetrahedron in strains of +-0.01: shear and bulk modulus, Young's modulus and Poisson's ratio.
#
# Guess: all three agree in small strains, with E = 150.
# Seen: the neo-Hookean one has three quarters of the shear modulus, a bulk modulus that is less by 19/24 of it, and so another
# Poisson's ratio: E is 105 for 150 at 0.25. At a ratio of 0 the bulk modulus is negative: a body grows or shrinks by itself. The
# Lame parameters go straight into the energy of Smith, de Goes and Kim ("Stable neo-Hookean flesh simulation", 2018), which
# takes others: mu' = 4/3 mu, lambda' = lambda + 5/6 mu. Give those to setLameParameters. The other two laws are right.
#   neo-Hookean, ratio 0.00: shear 56.3, bulk -9.38, E -169, ratio -2.50
#   corotated, ratio 0.00: shear 75, bulk 50, E 150, ratio 0.00
#   linear, ratio 0.00: shear 75, bulk 50, E 150, ratio 0.00
#   neo-Hookean, ratio 0.10: shear 51.1, bulk 8.52, E 51.1, ratio -0.50
#   corotated, ratio 0.10: shear 68.2, bulk 62.5, E 150, ratio 0.10
#   linear, ratio 0.10: shear 68.2, bulk 62.5, E 150, ratio 0.10
#   neo-Hookean, ratio 0.25: shear 45, bulk 52.5, E 105, ratio 0.17
#   corotated, ratio 0.25: shear 60, bulk 100, E 150, ratio 0.25
#   linear, ratio 0.25: shear 60, bulk 100, E 150, ratio 0.25
#   neo-Hookean, ratio 0.45: shear 38.8, bulk 459, E 113, ratio 0.46
#   corotated, ratio 0.45: shear 51.7, bulk 500, E 150, ratio 0.45
#   linear, ratio 0.45: shear 51.7, bulk 500, E 150, ratio 0.45
set -euo pipefail
want=3.24+dfsg-2
version=$(dpkg-query -W -f='${Version}' libbullet-dev 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs libbullet-dev $want, found '${version:-none}'"; exit 77; }
command -v g++ >/dev/null || { echo "needs g++"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > moduli.cpp <<'CPP'
#include <BulletSoftBody/btDeformableCorotatedForce.h>
#include <BulletSoftBody/btDeformableLinearElasticityForce.h>
#include <BulletSoftBody/btDeformableNeoHookeanForce.h>
#include <BulletSoftBody/btSoftBody.h>

#include <cstdio>

class Corner {
public:
    explicit Corner(btDeformableLagrangianForce& law) : law_(law), body_(&info_, 4, places_, masses_) {
        info_.m_sparsesdf.Initialize();
        body_.appendTetra(0, 1, 2, 3);
        for (int n = 0; n < 4; ++n) body_.m_nodes[n].index = n;
        body_.initializeDmInverse();
        body_.m_tetraScratches.resize(1);
        body_.m_tetraScratchesTn.resize(1);
        body_.setActivationState(DISABLE_DEACTIVATION);
        law_.addSoftBody(&body_);
    }

    // The volume is 1/6 and the edges are the axes, so that a force on a corner is a column of the stress.
    double stress(const btMatrix3x3& deformation, int row, int column) {
        btAlignedObjectArray<btVector3> forces;
        for (int n = 0; n < 4; ++n) {
            body_.m_nodes[n].m_x = body_.m_nodes[n].m_q = deformation * places_[n];
            body_.m_nodes[n].m_v.setZero();
            forces.push_back(btVector3(0, 0, 0));
        }
        body_.updateDeformation();
        body_.advanceDeformation();
        law_.addScaledExplicitForce(1, forces);
        return -6.0 * forces[column + 1][row];
    }

private:
    btDeformableLagrangianForce& law_;
    btSoftBodyWorldInfo info_;
    btVector3 places_[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    btScalar masses_[4] = {1, 1, 1, 1};
    btSoftBody body_;
};

void show(const char* name, double ratio, btDeformableLagrangianForce& law) {
    Corner corner(law);
    const btScalar h = 0.01f;
    const btMatrix3x3 longer(1 + h, 0, 0, 0, 1, 0, 0, 0, 1), shorter(1 - h, 0, 0, 0, 1, 0, 0, 0, 1);
    const btMatrix3x3 sheared(1, h, 0, h, 1, 0, 0, 0, 1);
    const double along = (corner.stress(longer, 0, 0) - corner.stress(shorter, 0, 0)) / (2 * h);
    const double across = (corner.stress(longer, 1, 1) - corner.stress(shorter, 1, 1)) / (2 * h);
    const double shear = corner.stress(sheared, 0, 1) / (2 * h);
    const double bulk = (along + 2 * across) / 3;
    std::printf("%s, ratio %.2f: shear %.3g, bulk %.3g, E %.3g, ratio %.2f\n", name, ratio, shear, bulk,
                9 * bulk * shear / (3 * bulk + shear), across / (along + across));
}

int main() {
    for (double ratio : {0.0, 0.1, 0.25, 0.45}) {
        btDeformableNeoHookeanForce neo_hookean(1, 1, 0);
        neo_hookean.setYoungsModulus(150);
        neo_hookean.setPoissonRatio(ratio);
        show("neo-Hookean", ratio, neo_hookean);
        btDeformableCorotatedForce corotated(neo_hookean.m_mu, neo_hookean.m_lambda);
        show("corotated", ratio, corotated);
        btDeformableLinearElasticityForce linear(neo_hookean.m_mu, neo_hookean.m_lambda, 0, 0);
        show("linear", ratio, linear);
    }
}
CPP
g++ -std=c++17 -O1 -w -I/usr/include/bullet -o moduli moduli.cpp -lBulletSoftBody -lBulletDynamics -lBulletCollision -lLinearMath
./moduli > seen
cat seen
diff seen - <<'SEEN'
neo-Hookean, ratio 0.00: shear 56.3, bulk -9.38, E -169, ratio -2.50
corotated, ratio 0.00: shear 75, bulk 50, E 150, ratio 0.00
linear, ratio 0.00: shear 75, bulk 50, E 150, ratio 0.00
neo-Hookean, ratio 0.10: shear 51.1, bulk 8.52, E 51.1, ratio -0.50
corotated, ratio 0.10: shear 68.2, bulk 62.5, E 150, ratio 0.10
linear, ratio 0.10: shear 68.2, bulk 62.5, E 150, ratio 0.10
neo-Hookean, ratio 0.25: shear 45, bulk 52.5, E 105, ratio 0.17
corotated, ratio 0.25: shear 60, bulk 100, E 150, ratio 0.25
linear, ratio 0.25: shear 60, bulk 100, E 150, ratio 0.25
neo-Hookean, ratio 0.45: shear 38.8, bulk 459, E 113, ratio 0.46
corotated, ratio 0.45: shear 51.7, bulk 500, E 150, ratio 0.45
linear, ratio 0.45: shear 51.7, bulk 500, E 150, ratio 0.45
SEEN
