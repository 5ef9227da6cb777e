// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/pictures/LensWish.h"
#include "app/pictures/LookWish.h"
#include "app/python/ScriptScene.h"
#include "model/base/Result.h"
#include "model/brush/changes/Push.h"
#include "model/brush/changes/Time.h"
#include "model/describe/Field.h"
#include "model/population/PropertyValues.h"

/// What the parts of the Python module share.
namespace crowd::model {
struct StateRecall;
struct Stagger;
} // namespace crowd::model

namespace crowd::app {

namespace py = pybind11;

class LongCall;
class ScriptPresets;
struct ScriptStates;
struct StateHandle;
class ScriptSession;
struct PythonBrush;
struct RecallOrder;

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

/// A template of a scene: a scene and an id, so that it follows undo. Where that is given out again
/// to another one, this one is gone.
struct TemplateHandle
{
    TemplateHandle(ScenePtr scene, model::TemplateId given)
        : owner(std::move(scene)), id(given), birth(owner ? owner->birthOf(given) : 0)
    {
    }

    ScenePtr owner;
    model::TemplateId id = 0;
    std::uint64_t birth = 0;

    /// The entry as it is now, or ScriptError when it was removed.
    [[nodiscard]] model::TemplateEntry entry() const;
    /// The loaded asset, or ScriptError with the reason why it is missing.
    [[nodiscard]] model::TemplatePtr asset() const;
};

/// A stage of a scene as it was when it was asked for.
struct StageHandle
{
    ScenePtr owner;
    model::StageEntry entry;
};

/// `with scene.edit("name"):` one undo step, or nothing at all when the block raises.
class EditBlock
{
public:
    EditBlock(ScenePtr scene, std::string text) : m_scene(std::move(scene)), m_text(std::move(text))
    {
    }
    EditBlock(EditBlock&& other) noexcept
        : m_scene(std::move(other.m_scene)), m_text(std::move(other.m_text)),
          m_isOpen(std::exchange(other.m_isOpen, false))
    {
    }
    /// One that was begun without `with` and forgotten is taken back.
    ~EditBlock() { end(false); }
    EditBlock(const EditBlock&) = delete;
    EditBlock& operator=(const EditBlock&) = delete;
    EditBlock& operator=(EditBlock&&) = delete;

    ScenePtr begin();
    void end(bool isKept);

private:
    ScenePtr m_scene;
    std::string m_text;
    bool m_isOpen = false;
};

/// A clip for reading.
struct ClipInfo
{
    std::string name;
    double seconds;
    int keyframes;
    double speed;
    bool loop;
    std::optional<float> seatHeight;
    std::string role;
};

/// What a script gave, for messages: its repr, cut.
[[nodiscard]] std::string shortly(const py::handle& given);
/// The id that a handle or a number stands for. Raises where the handle is another scene's.
[[nodiscard]] model::TemplateId templateIdOf(const ScenePtr& scene, const py::handle& given);

/// Where to look from: nothing (the scene's first camera), the name of one, or one.
using CameraKey = std::variant<std::monostate, std::string, model::Camera>;
/// Of one of the scene's; empty: its first one. Null: none of them.
[[nodiscard]] std::optional<std::string> cameraName(const CameraKey& key);
[[nodiscard]] std::optional<model::Camera> cameraOf(const ScriptScene& scene, const CameraKey& key);
/// Whatever Python takes for a path; "builtin:…" passes unchanged.
using FilePath = std::filesystem::path;
using Point3 = std::array<float, 3>;
/// Raises when it is not finite.
[[nodiscard]] glm::vec3 toVector(const Point3& point, const char* name);

using SceneClass = pybind11::class_<ScriptScene, ScenePtr>;
using SessionClass = pybind11::class_<ScriptSession, std::shared_ptr<ScriptSession>>;

/// For these, or for everybody. Raises where the name is empty, the number none, or somebody dead.
[[nodiscard]] ScriptEvent eventOf(const ScriptScene& scene, const std::string& name,
                                  const py::object& ids, float number);
/// Of the arguments of recall_state; raises where they are none.
[[nodiscard]] RecallOrder recallOrderOf(const ScriptScene& scene, float seconds,
                                        const std::optional<model::Stagger>& stagger,
                                        const py::object& ids,
                                        const std::optional<std::vector<std::string>>& columns);
/// Raises where a stage, or characters of whom there are some, could not be had.
void refuseMissing(const model::Scene& scene);
/// Of a list of keys; raises where one is none.
[[nodiscard]] PicturePasses passesNamed(const std::vector<std::string>& names);
/// How a picture is drawn, as scripts say it.
struct PictureKey
{
    LookWish look;
    LensWish lens{};
};

/// What scripts ask for with a picture is checked here; what stops it is raised.
[[nodiscard]] ScriptDrawing drawingOf(ScriptScene& scene, ScriptPicture request,
                                      const CameraKey& camera, const PictureKey& look,
                                      LongCall& call);
/// crowdbrush.Picture of the scene.
/// Arrays by the names of passes, which go to a file as well where there is a path.
[[nodiscard]] py::dict passesOf(ScriptScene& scene, ScriptPicture request, const CameraKey& camera,
                                const PictureKey& look, const std::optional<FilePath>& path,
                                LongCall& call);
[[nodiscard]] py::object pictureOf(ScriptScene& scene, ScriptPicture request,
                                   const CameraKey& camera, const PictureKey& look, LongCall& call);

/// What a class of ours takes is checked here: see the casters below.
void refuseUnmade(const py::handle& given);

/// Types that are classes in Python.
template<class T>
inline constexpr bool kIsBound = false;
template<model::Described T>
inline constexpr bool kIsBound<T> = true;
template<>
inline constexpr bool kIsBound<ScriptScene> = true;
template<>
inline constexpr bool kIsBound<ScriptSession> = true;
template<>
inline constexpr bool kIsBound<TemplateHandle> = true;
template<>
inline constexpr bool kIsBound<StageHandle> = true;
template<>
inline constexpr bool kIsBound<EditBlock> = true;
template<>
inline constexpr bool kIsBound<ClipInfo> = true;
template<>
inline constexpr bool kIsBound<model::Camera> = true;
template<>
inline constexpr bool kIsBound<model::Lighting> = true;
template<>
inline constexpr bool kIsBound<model::PropertyInfo> = true;
template<>
inline constexpr bool kIsBound<model::StrokeOutcome> = true;
template<>
inline constexpr bool kIsBound<PythonBrush> = true;
template<>
inline constexpr bool kIsBound<ScriptPresets> = true;
template<>
inline constexpr bool kIsBound<StateHandle> = true;
template<>
inline constexpr bool kIsBound<ScriptStates> = true;
template<>
inline constexpr bool kIsBound<model::StateRecall> = true;
template<>
inline constexpr bool kIsBound<model::BrushKind> = true;
template<>
inline constexpr bool kIsBound<model::BrushSelection> = true;
template<>
inline constexpr bool kIsBound<model::BrushOperator> = true;
template<>
inline constexpr bool kIsBound<model::HeadingMode> = true;
template<>
inline constexpr bool kIsBound<model::TimeMode> = true;
template<>
inline constexpr bool kIsBound<model::PushMode> = true;

/// pybind11 says what C++ it could not call; from now on these say which argument is wrong. After
/// all has been bound.
void speakOfArguments(py::module_& module);

void bindTemplates(py::module_& module);
void bindBrushes(py::module_& module);
void bindPresets(py::module_& module); ///< after the brushes
void bindProperties(py::module_& module);
void bindPictures(py::module_& module, SceneClass& scene); ///< cameras and pictures
void bindMovies(SceneClass& scene);
void bindTakes(py::module_& module, SceneClass& scene);
/// Brushes that scripts bring along; after the brushes.
void bindScriptBrushes(py::module_& module);
/// Runs a brush over the dabs of a stroke until there are no more, on this thread. What it raises
/// comes out of here, and what ends the call.
void paintDabs(const ScenePtr& scene, ScriptStrokeLink& dabs, const py::object& brush,
               LongCall* call = nullptr);
void bindStrokes(py::module_& module, SceneClass& scene);
void bindContents(py::module_& module, SceneClass& scene); ///< templates, stages, light
void bindStates(py::module_& module, SceneClass& scene);
void bindFeatures(SceneClass& scene);
void bindRelations(SceneClass& scene);
void bindEnvironment(SceneClass& scene); ///< places, paths, rules
/// Classes for places, rules and so on; after the scene.
void bindEntries(py::module_& module);
void bindScene(py::module_& module);
void bindSession(py::module_& module); ///< after the scene
void bindTakeKeeping(SessionClass& session);

} // namespace crowd::app

namespace pybind11::detail {

/// An object that was made by __new__ alone holds nothing; pybind11 would lend memory that nobody
/// has filled.
template<class T>
class type_caster<T, std::enable_if_t<crowd::app::kIsBound<T>>> : public type_caster_base<T>
{
public:
    bool load(handle given, bool mayConvert)
    {
        crowd::app::refuseUnmade(given);
        return type_caster_base<T>::load(given, mayConvert);
    }
};

/// None would be a scene that is not there.
template<>
class type_caster<crowd::app::ScenePtr>
    : public copyable_holder_caster<crowd::app::ScriptScene, crowd::app::ScenePtr>
{
public:
    bool load(handle given, bool mayConvert)
    {
        crowd::app::refuseUnmade(given);
        return !given.is_none() && copyable_holder_caster::load(given, mayConvert);
    }
};

} // namespace pybind11::detail
