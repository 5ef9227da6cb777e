// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QDialog>

#include "widgets/actions/ActionRegistry.h"
#include "widgets/state/EditorState.h"
#include "widgets/theme/Theme.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;

namespace crowd::app {

class ShortcutsPage;

/// What the artist chose once and for all; kept in the settings.
struct Preferences
{
    widgets::Theme theme = widgets::Theme::System;
    widgets::ButtonMapping buttons = widgets::ButtonMapping::Standard;
    widgets::PictureQuality quality = widgets::PictureQuality::Automatic;
    int samples = 4;          ///< a pixel, see widgets::ViewOptions
    int autosaveSeconds = 60; ///< 0: off
    int keyframeMegabytes = 512;
    int undoMegabytes = 256;
    bool groupsStrokes = false; ///< short ones without a pause are undone together
    QString language;           ///< "de"; empty: the system's
    bool showsWelcome = true;   ///< at a start without a file
    friend bool operator==(const Preferences&, const Preferences&) = default;

    [[nodiscard]] static Preferences load();
    void save() const;
};

/// Edits Preferences and the shortcuts. What is chosen is shown at once; accepting keeps it,
/// rejecting takes it back. Only the language waits until it is accepted.
class PreferencesDialog : public QDialog
{
    Q_OBJECT

public:
    PreferencesDialog(widgets::ActionRegistry& actions, QWidget* parent);

    void accept() override;
    void reject() override;
    [[nodiscard]] ShortcutsPage& shortcuts() { return *m_shortcuts; }

Q_SIGNALS:
    /// To be applied now.
    void changed(const crowd::app::Preferences& preferences);
    /// Another one, and it was accepted.
    void languageChosen(const QString& code);

private:
    [[nodiscard]] QWidget* generalPage();
    void fill();
    static void fillMemory(QSpinBox& box, int least, int megabytes);
    void choose();
    [[nodiscard]] Preferences chosen() const;

    const Preferences m_before;
    ShortcutsPage* m_shortcuts;
    QComboBox* m_theme;
    QComboBox* m_buttons;
    QComboBox* m_quality;
    QComboBox* m_samples;
    QComboBox* m_language;
    QDoubleSpinBox* m_autosave; ///< minutes
    QSpinBox* m_memory;         ///< of baked animations, MB
    QSpinBox* m_undoMemory;     ///< MB
    QCheckBox* m_groups;
    QLabel* m_languageNote;
    QCheckBox* m_welcome;
};

} // namespace crowd::app
