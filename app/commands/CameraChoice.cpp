// SPDX-License-Identifier: MIT
#include "app/commands/CameraChoice.h"

#include <algorithm>
#include <utility>

#include <QtCore/QFile>

#include "model/project/EnvironmentText.h"

namespace crowd::app {

namespace {

constexpr qint64 kLargestMove = qint64{64} << 20U; ///< bytes
constexpr const char* kTurntable = "turntable";

model::Result<model::DirectedCamera> cameraNamed(const model::Scene& scene, const std::string& name)
{
    const auto found = std::ranges::find(scene.cameras, name, &model::NamedCamera::name);
    if (found != scene.cameras.end()) {
        return model::directed(*found);
    }
    std::string names;
    for (const model::NamedCamera& camera : scene.cameras) {
        names += (names.empty() ? "" : ", ") + camera.name;
    }
    return model::Error{"There is no camera named \"" + name + "\". " +
                        (names.empty() ? "The scene has none; leave --camera away."
                                       : "The scene has: " + names + ".")};
}

/// The marks of a file in the place of the scene's.
model::Result<model::CameraTrack> trackOfFile(const std::string& path, model::Scene scene)
{
    QFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::ReadOnly)) {
        return model::Error{"--camera-move " + path + " cannot be read (" +
                            file.errorString().toStdString() +
                            "): give \"turntable\", or a file with the marks of a timeline."};
    }
    if (file.size() > kLargestMove) {
        return model::Error{"--camera-move " + path + " is too large for marks of a timeline."};
    }
    scene.timeline.clear();
    if (const auto read = model::readEnvironmentText(file.readAll().toStdString(), scene); !read) {
        return model::Error{"--camera-move " + path + ": " + read.error().message};
    }
    model::CameraTrack track(scene);
    if (!track.hasMoves()) {
        return model::Error{"--camera-move " + path +
                            " moves no camera: it needs {\"timeline\": [...]} with marks of the "
                            "kind \"camera\"."};
    }
    return track;
}

} // namespace

model::Result<model::CameraTrack> chosenCamera(const CameraChoice& choice,
                                               const model::Scene& scene)
{
    model::CameraTrack track(scene);
    if (!choice.camera.empty()) {
        auto named = cameraNamed(scene, choice.camera);
        if (!named) {
            return named.error();
        }
        track = model::CameraTrack(std::move(named).value());
    }
    if (choice.move.empty()) {
        return track;
    }
    if (choice.move == kTurntable) {
        return model::CameraTrack::turntable(track.at(choice.begin), choice.begin, choice.seconds);
    }
    if (!choice.camera.empty()) {
        return model::Error{"--camera-move " + choice.move +
                            " says which cameras it goes to: leave --camera away."};
    }
    return trackOfFile(choice.move, scene);
}

} // namespace crowd::app
