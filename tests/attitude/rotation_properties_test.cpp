#include "linkwright/attitude/rotation_properties.hpp"

#include <gtest/gtest.h>
