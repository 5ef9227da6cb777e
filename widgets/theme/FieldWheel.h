// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QObject>

class QWidget;

namespace crowd::widgets {

/// Keeps the mouse wheel from changing fields that it merely passes over: spin boxes, combo boxes
/// and sliders take it while they have the keyboard, else what they stand in scrolls.
class FieldWheel : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    /// From now on, if it is such a field; it outlives neither.
    void watch(QWidget& widget);
    void forget(QWidget& widget);

    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace crowd::widgets
