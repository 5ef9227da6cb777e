// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include "model/rules/triggers/AheadFree.h"
#include "model/rules/triggers/Arrived.h"
#include "model/rules/triggers/ClipEnded.h"
#include "model/rules/triggers/Entered.h"
#include "model/rules/triggers/Event.h"
#include "model/rules/triggers/Every.h"
#include "model/rules/triggers/FeatureChanged.h"
#include "model/rules/triggers/Left.h"
#include "model/rules/triggers/PathEnded.h"
#include "model/rules/triggers/RelatedDid.h"
#include "model/rules/triggers/SpeedLimit.h"
#include "model/rules/triggers/Start.h"
#include "model/rules/triggers/StateRecalled.h"
#include "model/rules/triggers/TagNear.h"
#include "model/rules/triggers/Waited.h"

namespace crowd::model {

/// All kinds of triggers, in the order of menus. One more stands here and in a header of its own.
using TriggerData =
    std::variant<triggers::Start, triggers::Event, triggers::Arrived, triggers::Entered,
                 triggers::Left, triggers::PathEnded, triggers::ClipEnded, triggers::StateRecalled,
                 triggers::FeatureChanged, triggers::RelatedDid, triggers::Every, triggers::TagNear,
                 triggers::SpeedLimit, triggers::Waited, triggers::AheadFree>;

} // namespace crowd::model
