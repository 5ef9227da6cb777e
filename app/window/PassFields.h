// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include <QtCore/QString>
#include <QtWidgets/QWidget>

#include "app/pictures/PicturePasses.h"

class QCheckBox;

namespace crowd::app {

/// Which passes are written with the colours of a picture. Proposes what was chosen last.
class PassFields : public QWidget
{
    Q_OBJECT

public:
    PassFields(QString settingsKey, QWidget* parent);

    /// With the colours; empty: a picture alone.
    [[nodiscard]] PicturePasses chosen() const;
    void remember() const;

private:
    QString m_settingsKey;
    std::vector<std::pair<const PicturePass*, QCheckBox*>> m_boxes;
};

} // namespace crowd::app
