// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/BendOperation.h"
#include "commands/recipe/BrushStrokeOperation.h"
#include "commands/recipe/FillEnvelopesOperation.h"
#include "commands/recipe/GrowOperation.h"
#include "commands/recipe/ImportOperation.h"
#include "commands/recipe/LassoOperation.h"
#include "commands/recipe/PruneOperation.h"
#include "commands/recipe/Recipe.h"
#include "commands/recipe/RedoOperation.h"
#include "commands/recipe/RegrowOperation.h"
#include "commands/recipe/RemoveLassoOperation.h"
#include "commands/recipe/SetParametersOperation.h"
#include "commands/recipe/SetProfileOperation.h"
#include "commands/recipe/SetWidthOperation.h"
#include "commands/recipe/TravelOperation.h"
#include "commands/recipe/UndoOperation.h"
