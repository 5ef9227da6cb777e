// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/brush/PropertyChange.h"

namespace crowd::model {

/// Whoever is related, by a kind that shares it, to somebody on whom a feature or a colour has just
/// been painted gets the same: one step away, unless the stroke means him too, or his group is
/// hidden or locked. Of several the one with the lowest id counts. Colours go by the names of
/// slots. Brushes of other kinds share nothing. `changed`, ascending, gets those whom it changes.
void shareWithRelated(const ChangeRequest& request, std::vector<IndividualId>& changed);

} // namespace crowd::model
