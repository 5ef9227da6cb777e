// SPDX-License-Identifier: MIT
#pragma once

/// All panels of the window. Each is a QDockWidget with a stable object name, made with the
/// editor's state, which outlives it; edits go through the document's transactions.
#include "widgets/docks/BrushPaletteDock.h"
#include "widgets/docks/BrushSettingsDock.h"
#include "widgets/docks/ColourDock.h"
#include "widgets/docks/EnvironmentDock.h"
#include "widgets/docks/FeaturesDock.h"
#include "widgets/docks/GroupsDock.h"
#include "widgets/docks/HistoryDock.h"
#include "widgets/docks/IndividualDock.h"
#include "widgets/docks/LightDock.h"
#include "widgets/docks/LooksDock.h"
#include "widgets/docks/PresetsDock.h"
#include "widgets/docks/RelationsDock.h"
#include "widgets/docks/RulesDock.h"
#include "widgets/docks/SceneDock.h"
#include "widgets/docks/StatesDock.h"
#include "widgets/docks/StrokesDock.h"
#include "widgets/docks/TakesDock.h"
#include "widgets/docks/TemplatesDock.h"
#include "widgets/docks/TimelineDock.h"
