// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtCore/QTimer>
#include <QtWidgets/QDialog>

#include "model/bake/KeyframeStore.h"
#include "model/scene/Scene.h"

class QListWidget;
class QPushButton;

namespace crowd::widgets {

/// The built-in cast as pictures, of which any number is chosen. Who is in the scene already is
/// shown, but not to be chosen again.
class LibraryDialog : public QDialog
{
    Q_OBJECT

public:
    /// Entries with their assets; `present` are those of the scene.
    LibraryDialog(std::vector<model::TemplateEntry> library,
                  const std::vector<model::TemplateEntry>& present, model::KeyframeStore& keyframes,
                  QWidget* parent);

    /// In the order of the library.
    [[nodiscard]] std::vector<model::TemplateEntry> chosen() const;

private:
    void fill(const std::vector<model::TemplateEntry>& present);
    void drawNextPicture();
    void refresh();

    std::vector<model::TemplateEntry> m_library;
    model::KeyframeStore& m_keyframes;
    QListWidget* m_list;
    QPushButton* m_add;
    QTimer m_drawing; ///< a picture each time, so that the dialog is there at once
    int m_drawn = 0;
};

} // namespace crowd::widgets
