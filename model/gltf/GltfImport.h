// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "model/base/Result.h"
#include "model/scene/Scene.h"
#include "model/scene/Stage.h"
#include "model/template/Template.h"

/// Reading glTF 2.0 (.glb, .gltf with files beside it or embedded data) as templates and stages.
/// Paths are UTF-8. All functions may run on any thread, and never throw; what cannot be read comes
/// back as one message that names the file, the place in it and the way out.
namespace crowd::model {

enum class FileKind { Template, Stage, Unknown };

/// A file with a skin or an animation is a template, any other glTF a stage. Reads only the JSON.
/// Unknown: no glTF that can be read; importing it tells why.
[[nodiscard]] FileKind sniffKind(const std::string& path);

/// Called now and then with 0..1; false cancels the import, which then fails with a message.
using ImportProgress = std::function<bool(float fraction)>;

/// The template with `settings` applied: scale, rotation and ground offset become its root
/// correction, root motion is taken out of the clips unless that is off.
Result<TemplatePtr> importTemplate(const std::string& path, const ImportSettings& settings = {},
                                   const ImportProgress& progress = {});

/// The default scene as static geometry, skinned meshes in their resting pose. Seats come from
/// extras "seats" of the file, its scene or any node (then in the node's frame).
Result<StagePtr> importStage(const std::string& path, const ImportProgress& progress = {});

} // namespace crowd::model
