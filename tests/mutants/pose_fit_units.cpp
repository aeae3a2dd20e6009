// What fits and judges poses in one unit, so that a wrong sign in one of them is what the others call.

#include "approximate/pose_field.cpp"
#include "approximate/pose_fit.cpp"
#include "approximate/pose_least_squares.cpp"
#include "approximate/pose_pairs.cpp"
#include "approximate/pose_result.cpp"
#include "approximate/pose_search.cpp"
#include "approximate/pose_target.cpp"
