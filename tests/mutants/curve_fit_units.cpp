// What fits, scans and judges curves in one unit, so that a wrong sign in one of them is what the others call.

#define LINKWRIGHT_ISA isa_scalar
#define LINKWRIGHT_LANES 1
#define LINKWRIGHT_KERNEL(name) name##_scalar

#include "approximate/circuit_drive.cpp"
#include "approximate/coupler_circuit.cpp"
#include "approximate/curve_least_squares.cpp"
#include "approximate/drive_verdict.cpp"
#include "approximate/driving_dyads.cpp"
#include "approximate/dyad_scan.cpp"
#include "approximate/dyad_scan_kernel.cpp"
#include "approximate/fit_hinges.cpp"
#include "approximate/fit_result.cpp"
#include "approximate/pair_rating.cpp"
#include "approximate/second_dyad_at.cpp"
