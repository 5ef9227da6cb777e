// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QDialog>

#include <glm/vec2.hpp>

class QCheckBox;
class QComboBox;
class QSpinBox;

namespace crowd::app {

/// What File > Save Picture asks before it asks for a name: the size in pixels, and whether what
/// lies behind crowd and stage is left out. Proposes what was chosen last.
class PictureDialog : public QDialog
{
    Q_OBJECT

public:
    /// `view`: size of the picture in the window, physical pixels.
    explicit PictureDialog(glm::ivec2 view, QWidget* parent);

    [[nodiscard]] glm::ivec2 chosenSize() const;
    [[nodiscard]] bool isTransparent() const;

    void accept() override;

private:
    void chooseSize(int index);
    void noteOwnSize();

    QComboBox* m_sizes;
    QSpinBox* m_width;
    QSpinBox* m_height;
    QCheckBox* m_transparent;
};

} // namespace crowd::app
