#pragma once

#include <nlohmann/json.hpp>

#include "files/json/json_fwd.hpp"
