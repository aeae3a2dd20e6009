// What scans and fits curves in one unit, so that a wrong sign in one of them is what the others call.

#define LINKWRIGHT_ISA isa_scalar
#define LINKWRIGHT_LANES 1
#define LINKWRIGHT_KERNEL(name) name##_scalar

#include "approximate/curve_least_squares.cpp"
#include "approximate/driving_dyads.cpp"
#include "approximate/dyad_scan.cpp"
#include "approximate/dyad_scan_kernel.cpp"
#include "approximate/fit_hinges.cpp"
#include "approximate/pair_rating.cpp"
#include "approximate/second_dyad_at.cpp"
