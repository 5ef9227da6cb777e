// SPDX-License-Identifier: MIT
#include "app/window/PictureController.h"

#include <optional>
#include <vector>

#include <QtCore/QFileInfo>
#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QMessageBox>

#include <glm/geometric.hpp>

#include "app/pictures/LensWish.h"
#include "app/pictures/PictureFile.h"
#include "app/pictures/PictureFormats.h"
#include "app/pictures/PictureMaker.h"
#include "app/window/PictureDialog.h"
#include "model/base/Translated.h"
#include "model/view/PropertyPaint.h"
#include "widgets/state/ShownLook.h"

namespace crowd::app {

namespace {

const QString kPictureFolder = QStringLiteral("picture/folder");
constexpr std::size_t kPictureKeyframeBytes = std::size_t{2} << 30U;

/// All that a picture shows, apart from the document: the artist paints on meanwhile.
struct PictureJob
{
    QString path;
    model::CrowdFramePtr frame;
    std::vector<model::StageEntry> stages;
    std::vector<model::WorldSeat> seats;
    PictureRequest request; ///< its spans are set where it is drawn
};

model::Result<void> drawPicture(PictureJob job, const model::KeepGoing& keepGoing)
{
    model::KeyframeStore keyframes(kPictureKeyframeBytes);
    auto maker = PictureMaker::create(keyframes);
    if (!maker) {
        return maker.error();
    }
    job.request.frame = job.frame;
    job.request.stages = job.stages;
    job.request.seats = job.seats;
    if (auto drawn = maker.value()->draw(job.request, keepGoing); !drawn) {
        return drawn;
    }
    return writePicture(job.path, maker.value()->pixels(), maker.value()->size(),
                        job.request.isTransparent);
}

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
    const QString path = askForPath();
    if (!path.isEmpty()) {
        draw(path, dialog);
    }
}

QString PictureController::askForPath()
{
    QSettings settings;
    const QString document = m_state.document().path();
    const QString usual = document.isEmpty()
                              ? QStandardPaths::writableLocation(QStandardPaths::PicturesLocation)
                              : QFileInfo(document).absolutePath();
    const QString folder = settings.value(kPictureFolder, usual).toString();
    QString filters;
    for (const PictureFormat& format : pictureFormats()) {
        QStringList patterns;
        for (const char* ending : format.endings) {
            patterns << QStringLiteral("*.") + QLatin1String(ending);
        }
        filters += (filters.isEmpty() ? QString() : QStringLiteral(";;")) +
                   QStringLiteral("%1 (%2)").arg(QLatin1String(format.name),
                                                 patterns.join(QLatin1Char(' ')));
    }
    QFileDialog dialog(m_window, tr("Save Picture"), folder, filters);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QLatin1String(pictureFormats().front().endings.front()));
    const QString name =
        document.isEmpty() ? tr("picture") : QFileInfo(document).completeBaseName();
    dialog.selectFile(name); // its ending comes with the kind of file that is chosen
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&](const QString& filter) {
        for (const PictureFormat& format : pictureFormats()) {
            if (filter.startsWith(QLatin1String(format.name))) {
                dialog.setDefaultSuffix(QLatin1String(format.endings.front()));
            }
        }
    });
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) {
        return {};
    }
    QString path = dialog.selectedFiles().front();
    settings.setValue(kPictureFolder, QFileInfo(path).absolutePath());
    return path;
}

void PictureController::draw(const QString& path, const PictureDialog& chosen)
{
    const auto lens = lensOf(chosen.lens(), m_state.camera());
    if (!lens) {
        m_state.showStatus(model::translated(lens.error()));
        return;
    }
    const widgets::ViewOptions& options = m_state.viewOptions();
    PictureJob job;
    job.path = path;
    job.frame = m_state.frame();
    if (render::lookInfo(options.look).isByProperty) {
        job.frame = model::framePaintedBy(m_state.scene(), *job.frame, options.property);
    }
    job.stages = m_state.scene().stages;
    job.seats = m_state.scene().worldSeats();
    job.request.lighting = m_state.scene().lighting;
    job.request.lights = m_state.scene().lights;
    job.request.lighting.showGroundGrid &= options.showGroundGrid;
    job.request.camera = m_state.camera();
    job.request.size = chosen.chosenSize();
    job.request.lens = lens.value();
    job.request.look = options.look;
    job.request.showShadows = options.showShadows;
    if (const model::LookPreset* look = widgets::shownLook(m_state)) {
        job.request.ownLook = *look;
    }
    job.request.isTransparent = chosen.isTransparent();
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
