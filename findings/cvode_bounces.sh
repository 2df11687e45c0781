#!/usr/bin/env bash
# CVODE of SUNDIALS 6.4.1 (Debian 12: libsundials-dev 6.4.1+dfsg1-3, compiled by gcc): a grain falls from height 1 at gravity 1, its
# touch of the ground is found as a root of the height, its velocity is turned round, CVodeReInit, and so on: twenty elastic bounces.
#
# Guess: at sqrt(2) times 1, 3, 5 ... 39, or an error, or a grain that falls through.
# Seen: twenty roots are two bounces. The root is found with a height of some -1e-13, so that the grain, on its way up, crosses zero
# again at once, which is a root; its velocity is turned round to down, then up again, and so on, until a height happens to be not
# below zero. Each call returns CV_ROOT_RETURN, and the energy stays 1.000. With the height set to 0 before CVodeReInit it
# is right, as a root right at the start is looked at anew, and with CVodeSetRootDirection(-1), roots on the way down, as well.
#   as it is: 20 roots, the first at 1.414, the last at 4.243, energy 1.000
#   height set to 0: 20 roots, the first at 1.414, the last at 55.154, energy 1.000
#   roots on the way down: 20 roots, the first at 1.414, the last at 55.154, energy 1.000
#   true: 20 roots, the first at 1.414, the last at 55.154, energy 1.000
set -euo pipefail
want=6.4.1+dfsg1-3
version=$(dpkg-query -W -f='${Version}' libsundials-dev 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs libsundials-dev $want, found '${version:-none}'"; exit 77; }
command -v gcc >/dev/null || { echo "needs gcc"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > bounce.c <<'C'
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

static int fall(double time, N_Vector state, N_Vector rate, void* none) {
    NV_Ith_S(rate, 0) = NV_Ith_S(state, 1);
    NV_Ith_S(rate, 1) = -1;
    return 0;
}

static int height(double time, N_Vector state, double* root, void* none) {
    root[0] = NV_Ith_S(state, 0);
    return 0;
}

static void bounce(const char* name, int set_height, int downwards) {
    SUNContext context;
    SUNContext_Create(NULL, &context);
    N_Vector state = N_VNew_Serial(2, context);
    SUNMatrix matrix = SUNDenseMatrix(2, 2, context);
    NV_Ith_S(state, 0) = 1;
    NV_Ith_S(state, 1) = 0;
    void* cvode = CVodeCreate(CV_ADAMS, context);
    CVodeInit(cvode, fall, 0, state);
    CVodeSStolerances(cvode, 1e-8, 1e-8);
    CVodeSetLinearSolver(cvode, SUNLinSol_Dense(state, matrix, context), matrix);
    CVodeRootInit(cvode, 1, height);
    int direction = -1;
    if (downwards) CVodeSetRootDirection(cvode, &direction);
    double time = 0, first = 0;
    int bounces = 0;
    for (; bounces < 20 && CVode(cvode, time + 10, state, &time, CV_NORMAL) == CV_ROOT_RETURN; ++bounces) {
        if (bounces == 0) first = time;
        NV_Ith_S(state, 1) *= -1;
        if (set_height) NV_Ith_S(state, 0) = 0;
        CVodeReInit(cvode, time, state);
    }
    printf("%s: %d roots, the first at %.3f, the last at %.3f, energy %.3f\n", name, bounces, first, time,
           NV_Ith_S(state, 0) + NV_Ith_S(state, 1) * NV_Ith_S(state, 1) / 2);
}

int main(void) {
    bounce("as it is", 0, 0);
    bounce("height set to 0", 1, 0);
    bounce("roots on the way down", 0, 1);
    printf("true: 20 roots, the first at 1.414, the last at %.3f, energy 1.000\n", 39 * 1.4142135624);
    return 0;
}
C
gcc -o bounce bounce.c -lsundials_cvode -lsundials_nvecserial -lsundials_sunmatrixdense -lsundials_sunlinsoldense
./bounce > seen
cat seen
diff seen - <<'SEEN'
as it is: 20 roots, the first at 1.414, the last at 4.243, energy 1.000
height set to 0: 20 roots, the first at 1.414, the last at 55.154, energy 1.000
roots on the way down: 20 roots, the first at 1.414, the last at 55.154, energy 1.000
true: 20 roots, the first at 1.414, the last at 55.154, energy 1.000
SEEN
