// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include "model/rules/conditions/Chance.h"
#include "model/rules/conditions/FollowsPath.h"
#include "model/rules/conditions/HasFeature.h"
#include "model/rules/conditions/HasTag.h"
#include "model/rules/conditions/InPlace.h"
#include "model/rules/conditions/IsFull.h"
#include "model/rules/conditions/IsSeated.h"
#include "model/rules/conditions/Number.h"
#include "model/rules/conditions/OfTemplate.h"
#include "model/rules/conditions/Payload.h"
#include "model/rules/conditions/PeopleIn.h"
#include "model/rules/conditions/Property.h"
#include "model/rules/conditions/Related.h"
#include "model/rules/conditions/Speed.h"

namespace crowd::model {

/// All kinds of conditions, in the order of menus. One more stands here and in a header of its own.
using ConditionData =
    std::variant<conditions::HasTag, conditions::HasFeature, conditions::OfTemplate,
                 conditions::InPlace, conditions::FollowsPath, conditions::IsSeated,
                 conditions::Chance, conditions::Number, conditions::Speed, conditions::Payload,
                 conditions::IsFull, conditions::PeopleIn, conditions::Related,
                 conditions::Property>;

} // namespace crowd::model
