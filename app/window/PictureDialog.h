// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <QtWidgets/QDialog>

#include <glm/vec2.hpp>

#include "app/pictures/LensWish.h"
#include "app/pictures/PicturePasses.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace crowd::app {

class PassFields;
class PictureSizeFields;

/// What File > Save Picture asks before it asks for a name: the size in pixels, whether what lies
/// behind crowd and stage is left out, what is sharp, and what else the file holds. Proposes what
/// was chosen last.
class PictureDialog : public QDialog
{
    Q_OBJECT

public:
    /// `view`: size of the picture in the window, physical pixels. `selectedDepth`: metres to who
    /// is selected, if somebody is.
    PictureDialog(glm::ivec2 view, const model::Camera& camera, std::optional<double> selectedDepth,
                  QWidget* parent);

    [[nodiscard]] glm::ivec2 chosenSize() const;
    [[nodiscard]] bool isTransparent() const;
    [[nodiscard]] LensWish lens() const;
    /// With the colours; empty: a picture alone.
    [[nodiscard]] PicturePasses passes() const;

    void accept() override;

private:
    void addLens(QFormLayout& form, const model::Camera& camera,
                 std::optional<double> selectedDepth);
    void chooseFocus(int index);
    void noteOwnFocus();

    PictureSizeFields* m_size;
    QCheckBox* m_transparent;
    QCheckBox* m_hasLens;
    QComboBox* m_focuses;
    QDoubleSpinBox* m_focus;
    QDoubleSpinBox* m_fStop;
    PassFields* m_passes;
};

} // namespace crowd::app
