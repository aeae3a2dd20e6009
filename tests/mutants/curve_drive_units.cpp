// What judges curves in one unit, so that a wrong sign in one of them is what the others call.

#include "approximate/circuit_drive.cpp"
#include "approximate/coupler_circuit.cpp"
#include "approximate/drive_verdict.cpp"
#include "approximate/fit_result.cpp"
