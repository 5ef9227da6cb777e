// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/scene/Scene.h"
#include "model/template/Template.h"

namespace crowd::model {

/// How a foreign character probably has to be put upright, to scale and on the ground.
struct ImportProposal
{
    ImportSettings settings;
    /// One sentence for each thing that differs from taking the file as it is; empty when nothing
    /// does. For the artist.
    std::vector<Message> reasons;
    float height = 0.0F; ///< metres, with the settings
};

/// Looks at a template that was imported with default settings: its size against that of living
/// things, which way it stands, which way it faces (by the nodes of its left and right side, else
/// the way it walks) and how far it is from the ground.
[[nodiscard]] ImportProposal proposeImport(const Template& asset);

} // namespace crowd::model
