// SPDX-License-Identifier: MIT
#include "app/commands/CameraChoice.h"

#include <algorithm>
#include <utility>

#include <QtCore/QFile>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>

#include "model/project/EnvironmentText.h"

namespace crowd::app {

namespace {

constexpr qint64 kLargestMove = qint64{64} << 20U; ///< bytes
constexpr const char* kWanted =
    "It needs marks such as {\"timeline\": [{\"seconds\": 2, \"kind\": \"camera\", "
    "\"camera\": \"Stage\", \"travel\": 3}]}.";
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

/// An environment of what is in a file: {"timeline": [...]}, or the list alone; marks without a
/// number get one. Empty: it is something else.
std::string timelineIn(const QByteArray& content)
{
    const QString kTimeline = QStringLiteral("timeline");
    const QString kId = QStringLiteral("id");
    const QJsonDocument document = QJsonDocument::fromJson(content);
    QJsonObject top = document.object();
    if (document.isArray()) {
        top[kTimeline] = document.array();
    }
    if (!top[kTimeline].isArray()) {
        return {};
    }
    QJsonArray marks = top[kTimeline].toArray();
    for (qsizetype i = 0; i < marks.size(); ++i) {
        QJsonObject mark = marks[i].toObject();
        if (!mark.isEmpty() && !mark.contains(kId)) {
            mark[kId] = i + 1;
            marks[i] = mark;
        }
    }
    return QJsonDocument(QJsonObject{{kTimeline, marks}}).toJson().toStdString();
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
    const std::string timeline = timelineIn(file.readAll());
    if (timeline.empty()) {
        return model::Error{"--camera-move " + path + " is no timeline. " + kWanted};
    }
    if (const auto read = model::readEnvironmentText(timeline, scene); !read) {
        return model::Error{"--camera-move " + path + ": " + read.error().message};
    }
    model::CameraTrack track(scene);
    if (!track.hasMoves()) {
        return model::Error{"--camera-move " + path + " moves no camera. " + kWanted};
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
