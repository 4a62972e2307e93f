#pragma once
#include "Robot.h"
#include "base/Upward.h"
#include "robot/Robot.h"
