// SPDX-License-Identifier: MIT
#include "app/window/PictureController.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <QtCore/QFileInfo>
#include <QtCore/QStandardPaths>
#include <QtWidgets/QMessageBox>

#include <glm/geometric.hpp>

#include "app/pictures/LensWish.h"
#include "app/pictures/PictureFormats.h"
#include "app/pictures/PictureMaker.h"
#include "app/window/AskForPath.h"
#include "app/window/PictureDialog.h"
#include "app/window/PictureJob.h"
#include "model/base/Translated.h"

namespace crowd::app {

namespace {

constexpr std::size_t kPictureKeyframeBytes = std::size_t{2} << 30U;

struct NamedJob
{
    QString path;
    PictureJob picture;
    PicturePasses passes;
    model::Scene scene;
    model::CrowdFramePtr frame;
};

model::Result<void> drawPicture(const NamedJob& job, const model::KeepGoing& keepGoing)
{
    model::KeyframeStore keyframes(kPictureKeyframeBytes);
    auto maker = PictureMaker::create(keyframes);
    if (!maker) {
        return maker.error();
    }
    PictureJob picture = job.picture;
    const PictureRequest& request = picture.ask(job.scene, job.frame);
    return maker.value()->save(job.path, request, job.passes, keepGoing);
}

std::vector<SaveKind> pictureKinds(bool hasPasses)
{
    std::vector<SaveKind> kinds;
    for (const PictureFormat& format : pictureFormats()) {
        if (hasPasses && format.passes == PassRoom::None) {
            continue;
        }
        SaveKind& kind = kinds.emplace_back();
        kind.name = QLatin1String(format.name);
        for (const char* ending : format.endings) {
            kind.endings << QLatin1String(ending);
        }
    }
    return kinds;
}

constexpr double kFrameSeconds = 1.0 / 30.0; ///< that motion is said over

/// Metres along the view axis to the middle of who is selected; none: nobody is, or behind it.
std::optional<double> selectedDepth(const widgets::EditorState& state)
{
    const model::Camera& camera = state.camera();
    const auto frame = state.frame();
    const model::Population& people = frame->population;
    const auto positions = people.column(model::columns::position);
    double sum = 0.0;
    int count = 0;
    for (const model::IndividualId id : state.selection().ids()) {
        if (const std::size_t row = people.rowOf(id); row != model::Population::npos) {
            const glm::vec3 way = positions[row] - camera.position;
            sum += static_cast<double>(glm::dot(way, camera.forward()));
            ++count;
        }
    }
    const double depth = count > 0 ? sum / count : 0.0;
    return depth > kLeastFocus ? std::optional(depth) : std::nullopt;
}

} // namespace

PictureController::PictureController(widgets::EditorState& state, QWidget* window)
    : QObject(window), m_state(state), m_window(window),
      m_task(window, [&state] { return !state.document().isEditOpen(); })
{
}

void PictureController::save(glm::ivec2 view)
{
    if (m_task.isRunning()) {
        m_state.showStatus(tr("Another picture is still being drawn."));
        return;
    }
    PictureDialog dialog(view, m_state.camera(), selectedDepth(m_state), m_window);
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    const QString path = askForPath(
        m_window, tr("Save Picture"), pictureKinds(!dialog.passes().empty()),
        QStringLiteral("picture/folder"), m_state.document().path(),
        QStandardPaths::writableLocation(QStandardPaths::PicturesLocation), tr("picture"));
    if (!path.isEmpty()) {
        draw(path, dialog);
    }
}

void PictureController::draw(const QString& path, const PictureDialog& chosen)
{
    const auto lens = lensOf(chosen.lens(), m_state.camera());
    if (!lens) {
        m_state.showStatus(model::translated(lens.error()));
        return;
    }
    NamedJob job{path, PictureJob::ofView(m_state), chosen.passes(), m_state.scene(),
                 m_state.frame()};
    job.picture.request.size = chosen.chosenSize();
    job.picture.request.lens = lens.value();
    job.picture.request.isTransparent = chosen.isTransparent();
    if (needAny(job.passes, PassNeed::Motion)) {
        const double before = m_state.transport().seconds() - kFrameSeconds;
        job.picture.request.earlier =
            render::EarlierMoment{m_state.session().frame(std::max(before, 0.0)), m_state.camera()};
    }
    m_task.start(
        tr("Saving the picture…"),
        [job = std::move(job)](const widgets::TaskReport& report) {
            const QString what = tr("Drawing %1").arg(QFileInfo(job.path).fileName());
            report(what, 0.0F);
            return drawPicture(
                job, [&](double share) { return report(what, static_cast<float>(share)); });
        },
        [this, path](const model::Result<void>& saved) {
            if (saved) {
                m_state.showStatus(tr("Saved %1").arg(QFileInfo(path).fileName()));
                return;
            }
            QMessageBox::warning(m_window, tr("The picture could not be saved"),
                                 model::translated(saved.error()));
        });
}

} // namespace crowd::app
