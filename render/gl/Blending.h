// SPDX-License-Identifier: MIT
#pragma once

/// How what is drawn meets what is there, for glEnable(GL_BLEND). Whoever sets another way than the
/// usual one sets that again. The alpha of a picture says who is highlighted: only where the
/// picture is transparent it changes.
namespace crowd::render {

/// The usual way: covers by its alpha.
void blendOver(bool isTransparent);
/// Light on top.
void blendAdding();
/// Darkens.
void blendMultiplying();

} // namespace crowd::render
