// SPDX-License-Identifier: MIT
#pragma once

#include <compare>

#include "model/template/Template.h"

namespace crowd::render {

/// How a picture is repeated beyond its edges, and smoothed.
struct Sampling
{
    model::Wrap wrapU = model::Wrap::Repeat;
    model::Wrap wrapV = model::Wrap::Repeat;
    bool isNearest = false;
    bool isBetweenMips = true; ///< blends two mipmaps
    friend auto operator<=>(const Sampling&, const Sampling&) = default;
};

} // namespace crowd::render
