// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/python/ScriptScene.h"
#include "model/base/Result.h"

/// What the parts of the Python module share.
namespace crowd::app {

namespace py = pybind11;

/// crowdbrush.Error, with the message the editor would show.
class ScriptError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// The value, or the message as a Python exception. Third-party code between Python and ours needs
/// exceptions; they go no further than the module.
template<class T>
T valueOrRaise(model::Result<T> result)
{
    if (!result) {
        throw ScriptError(result.error().message);
    }
    if constexpr (!std::is_void_v<T>) {
        return std::move(result).value();
    }
}

using ScenePtr = std::shared_ptr<ScriptScene>;

/// A template of a scene: a scene and an id, so that it follows undo.
struct TemplateHandle
{
    ScenePtr owner;
    model::TemplateId id = 0;

    /// The entry as it is now, or ScriptError when it was removed.
    [[nodiscard]] model::TemplateEntry entry() const;
    /// The loaded asset, or ScriptError with the reason why it is missing.
    [[nodiscard]] model::TemplatePtr asset() const;
};

/// Where to look from: nothing (the scene's first camera), the name of one, or one.
using CameraKey = std::variant<std::monostate, std::string, model::Camera>;
[[nodiscard]] std::optional<model::Camera> cameraOf(const ScriptScene& scene, const CameraKey& key);
/// Whatever Python takes for a path; "builtin:…" passes unchanged.
using FilePath = std::filesystem::path;
using Point3 = std::array<float, 3>;
/// Raises when it is not finite.
[[nodiscard]] glm::vec3 toVector(const Point3& point, const char* name);

using SceneClass = pybind11::class_<ScriptScene, ScenePtr>;

/// For these, or for everybody. Raises where the name is empty, the number none, or somebody dead.
[[nodiscard]] ScriptEvent eventOf(const model::Scene& scene, const std::string& name,
                                  const py::object& ids, float number);
/// crowdbrush.Picture of the scene at a time, or of this frame.
[[nodiscard]] py::object pictureOf(ScriptScene& scene, const glm::ivec2& size,
                                   const CameraKey& camera, const std::string& look, double time,
                                   model::CrowdFramePtr frame);

void bindTemplates(py::module_& module);
void bindBrushes(py::module_& module);
void bindPictures(py::module_& module, SceneClass& scene); ///< cameras and pictures
/// Brushes that scripts bring along; after the brushes.
void bindScriptBrushes(py::module_& module);
/// Runs a brush over the dabs of a stroke until there are no more, on this thread. What it raises
/// comes out of here.
void paintDabs(const ScenePtr& scene, ScriptStrokeLink& dabs, const py::object& brush);
void bindStrokes(py::module_& module, SceneClass& scene);
void bindContents(py::module_& module, SceneClass& scene); ///< templates, stages, light
void bindScene(py::module_& module);
void bindSession(py::module_& module); ///< after the scene

} // namespace crowd::app
