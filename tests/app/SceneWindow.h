// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>
#include <QtCore/QTemporaryDir>
#include <QtTest/QSignalSpy>

#include "app/window/MainWindow.h"
#include "model/document/SceneEdit.h"
#include "model/project/ProjectFile.h"
#include "tests/app/PlainScene.h"
#include "tests/app/WindowTools.h"
#include "widgets/theme/Theme.h"

/// What tests of the editor's real window share: scenes, and a window with settings of its own.
namespace crowd::testing {

inline constexpr int kPatienceMs = 10'000;

inline void moveEverybody(model::SceneDocument& document, float x)
{
    const auto present = document.scene().population.ids();
    const std::vector<model::IndividualId> ids(present.begin(), present.end());
    const glm::vec3 place(x, 0.0F, 0.0F);
    const auto edit = document.beginEdit().value();
    edit->setColumn(model::columns::position, ids, std::span<const glm::vec3>(&place, 1));
    edit->commit(QStringLiteral("Move"));
}

class SceneWindow
{
protected:
    static void prepare(const char* name)
    {
        QCoreApplication::setOrganizationName(QStringLiteral("CrowdbrushTest"));
        QCoreApplication::setApplicationName(QString::fromLatin1(name));
        QStandardPaths::setTestModeEnabled(true);
        qputenv("CROWDBRUSH_RESOURCES", CROWD_RESOURCES);
    }
    void begin()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder->path());
        QSettings().clear();
        QSettings().setValue(QStringLiteral("preferences/pictureQuality"), QStringLiteral("fast"));
        widgets::applyTheme(
            widgets::Theme::System); // as the program does, before there are widgets
        openWindow();
    }
    void openWindow()
    {
        m_window = std::make_unique<app::MainWindow>();
        m_window->resize(1100, 720);
        m_window->state().transport().setPlaying(false);
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get())); // shortcuts go to the active one
    }
    void openScene(const model::Scene& scene, const QString& name)
    {
        QVERIFY(model::saveProject(scene, pathOf(name)).isOk());
        QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
        m_window->files().openPath(pathOf(name));
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatienceMs);
        // On a busy machine it has shown how far it is, in a window of its own.
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    }
    [[nodiscard]] QString pathOf(const QString& name) const { return m_folder->filePath(name); }
    [[nodiscard]] model::SceneDocument& document() const { return m_window->document(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<app::MainWindow> m_window;
};

} // namespace crowd::testing
