// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include "model/rules/actions/AddTag.h"
#include "model/rules/actions/AddToNumber.h"
#include "model/rules/actions/Again.h"
#include "model/rules/actions/Appear.h"
#include "model/rules/actions/Flee.h"
#include "model/rules/actions/Follow.h"
#include "model/rules/actions/FollowPath.h"
#include "model/rules/actions/GoOn.h"
#include "model/rules/actions/GoToPerson.h"
#include "model/rules/actions/GoToPlace.h"
#include "model/rules/actions/LeaveScene.h"
#include "model/rules/actions/LookAt.h"
#include "model/rules/actions/OneOf.h"
#include "model/rules/actions/PlayClip.h"
#include "model/rules/actions/RemoveTag.h"
#include "model/rules/actions/Repeat.h"
#include "model/rules/actions/SendEvent.h"
#include "model/rules/actions/SetFeature.h"
#include "model/rules/actions/SetNumber.h"
#include "model/rules/actions/SetProperty.h"
#include "model/rules/actions/SetSpeed.h"
#include "model/rules/actions/SitDown.h"
#include "model/rules/actions/StandUp.h"
#include "model/rules/actions/Stop.h"
#include "model/rules/actions/TakeOnState.h"
#include "model/rules/actions/TellLight.h"
#include "model/rules/actions/TurnTo.h"
#include "model/rules/actions/Wait.h"
#include "model/rules/actions/WaitForEvent.h"

namespace crowd::model {

/// All kinds of actions, in the order of menus. One more stands here and in a header of its own.
using ActionData =
    std::variant<actions::PlayClip, actions::TurnTo, actions::LookAt, actions::SitDown,
                 actions::StandUp, actions::FollowPath, actions::GoToPlace, actions::GoToPerson,
                 actions::Follow, actions::Flee, actions::Stop, actions::GoOn, actions::SetSpeed,
                 actions::Wait, actions::WaitForEvent, actions::Repeat, actions::OneOf,
                 actions::Again, actions::SendEvent, actions::AddTag, actions::RemoveTag,
                 actions::SetProperty, actions::SetFeature, actions::TakeOnState,
                 actions::TellLight, actions::SetNumber, actions::AddToNumber, actions::Appear,
                 actions::LeaveScene>;

} // namespace crowd::model
