// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>
#include <QtWidgets/QWidget>

#include <glm/vec2.hpp>

class QCheckBox;
class QComboBox;
class QSpinBox;

namespace crowd::app {

/// The size of a picture in pixels: usual ones by name, and any other. Proposes what was chosen
/// last, under a key of the settings.
class PictureSizeFields : public QWidget
{
    Q_OBJECT

public:
    /// `view`: size of the picture in the window, physical pixels. Others than multiples of `step`
    /// cannot be chosen.
    PictureSizeFields(glm::ivec2 view, int mostPixelsASide, int step, const QString& settingsKey,
                      QWidget* parent);

    [[nodiscard]] glm::ivec2 chosen() const;
    void remember() const;

private:
    void chooseSize(int index);
    void noteOwnSize();
    void changeTheOther(const QSpinBox* changed);

    const int m_step;
    QString m_settingsKey;
    QComboBox* m_sizes;
    QSpinBox* m_width;
    QSpinBox* m_height;
    QCheckBox* m_proportions;
    double m_widthToHeight = 1.0; ///< where proportions are kept
};

} // namespace crowd::app
