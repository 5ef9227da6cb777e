// SPDX-License-Identifier: MIT
#pragma once

#include "model/population/Population.h"

namespace crowd::model {

/// How people were at earlier moments, for brushes that give it back. Whoever is not in one of them
/// was not there. Columns are shared with the scene until one of them changes.
struct EarlierPeople
{
    /// Each as the step left it that created him; those of a file as they were when it was opened.
    Population created;
    Population saved;  ///< when the document was opened, or saved last
    Population before; ///< when the last brush but those that restore was taken up
};

} // namespace crowd::model
