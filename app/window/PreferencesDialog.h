// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QDialog>

#include "widgets/actions/ActionRegistry.h"
#include "widgets/state/EditorState.h"
#include "widgets/theme/Theme.h"

class QCheckBox;
class QComboBox;
class QSpinBox;

namespace crowd::app {

/// What the artist chose once and for all; kept in the settings.
struct Preferences
{
    widgets::Theme theme = widgets::Theme::System;
    widgets::ButtonMapping buttons = widgets::ButtonMapping::Standard;
    int autosaveSeconds = 60; ///< 0: off
    int keyframeMegabytes = 512;
    QString language; ///< "de"; empty: the system's

    [[nodiscard]] static Preferences load();
    void save() const;
};

/// Edits Preferences and the shortcuts. Accepting saves them; the caller applies them.
class PreferencesDialog : public QDialog
{
    Q_OBJECT

public:
    PreferencesDialog(widgets::ActionRegistry& actions, QWidget* parent);

private:
    [[nodiscard]] QWidget* generalPage();
    [[nodiscard]] QWidget* shortcutsPage();
    void savePreferences();

    widgets::ActionRegistry& m_actions;
    QComboBox* m_theme;
    QComboBox* m_buttons;
    QComboBox* m_language;
    QSpinBox* m_autosave;
    QSpinBox* m_memory;
};

} // namespace crowd::app
