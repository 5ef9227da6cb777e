// SPDX-License-Identifier: MIT
#include "app/window/FileQueue.h"

#include <QtCore/QFileInfo>
#include <QtCore/QProcess>
#include <QtWidgets/QApplication>

#include "app/window/AssetController.h"
#include "app/window/FileController.h"
#include "model/project/AssetPaths.h"

namespace crowd::app {

namespace {

constexpr int kLookMs = 50;

struct SortedFiles
{
    QStringList scenes;
    QStringList models;
};

SortedFiles sorted(const QStringList& files)
{
    SortedFiles all;
    for (const QString& given : files) {
        const QString builtin = model::isBuiltin(given.toStdString())
                                    ? model::assetFile(given.toStdString())
                                    : QString();
        const QString file = builtin.isEmpty() ? given : builtin;
        const bool isScene =
            QFileInfo(file).suffix().compare(QStringLiteral("crowd"), Qt::CaseInsensitive) == 0;
        (isScene ? all.scenes : all.models) << QFileInfo(file).absoluteFilePath();
    }
    return all;
}

void openInWindowsOfTheirOwn(const QStringList& scenes)
{
    for (const QString& scene : scenes) {
        QProcess::startDetached(QCoreApplication::applicationFilePath(), {scene});
    }
}

} // namespace

FileQueue::FileQueue(FileController& files, AssetController& assets, QObject* parent)
    : QObject(parent), m_files(files), m_assets(assets)
{
    connect(&m_timer, &QTimer::timeout, this, &FileQueue::next);
}

void FileQueue::openAtStart(const QStringList& files)
{
    SortedFiles all = sorted(files);
    const QStringList examples = FileController::examples();
    // Of a scene that is named it is asked when it opens.
    if (!(all.scenes.isEmpty() ? m_files.offerRecovery() : m_files.offerUntitledRecovery())) {
        if (!all.scenes.isEmpty()) {
            m_files.openPath(all.scenes.takeFirst());
        } else if (!all.models.isEmpty()) {
            m_files.newGround();
        } else if (!examples.isEmpty()) {
            m_files.openPath(examples.front());
        } else {
            m_files.newTheatre();
        }
    }
    openInWindowsOfTheirOwn(all.scenes);
    add(all.models, false);
}

void FileQueue::drop(const QStringList& files)
{
    SortedFiles all = sorted(files);
    if (!all.scenes.isEmpty()) {
        m_files.openPath(all.scenes.takeFirst());
    }
    openInWindowsOfTheirOwn(all.scenes);
    add(all.models, true);
}

void FileQueue::add(const QStringList& models, bool asks)
{
    m_brought = m_models.empty() ? 0 : m_brought;
    for (const QString& model : models) {
        m_models.push_back({model, asks});
    }
    if (!m_models.empty()) {
        m_timer.start(kLookMs);
    }
}

void FileQueue::next()
{
    const bool isFree =
        !m_files.isBusy() && m_assets.mayStart() && QApplication::activeModalWidget() == nullptr;
    if (!isFree) {
        return;
    }
    if (m_models.empty()) {
        m_timer.stop();
        return;
    }
    const int all = m_brought + static_cast<int>(m_models.size());
    const Model model = m_models.front();
    m_models.pop_front();
    m_assets.bring(model.path, model.asks, {++m_brought, all});
}

} // namespace crowd::app
