// SPDX-License-Identifier: MIT
#pragma once

#include "model/bake/ClipBaker.h"

/// Clips that somebody in the process has baked already and still keeps: another scene, the
/// thumbnails, a picture. Any thread.
namespace crowd::model {

/// The complete clip, or null when it has to be baked.
[[nodiscard]] BakedClipPtr findSharedClip(const TemplatePtr& asset, int clipIndex);

void shareClip(const TemplatePtr& asset, int clipIndex, const BakedClipPtr& clip);

} // namespace crowd::model
