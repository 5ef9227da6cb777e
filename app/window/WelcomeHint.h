// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QFrame>

#include "model/document/SceneDocument.h"

namespace crowd::app {

/// The first lines for somebody who has never painted a crowd, at the head of the picture. Goes
/// for good with the first edits or when it is closed; the settings remember that. A child of the
/// picture; the document outlives it.
class WelcomeHint : public QFrame
{
    Q_OBJECT

public:
    /// Shows a hint over the picture unless it has been seen.
    static void showOnce(QWidget* picture, const model::SceneDocument& document);

protected:
    bool eventFilter(QObject* picture, QEvent* event) override;

private:
    WelcomeHint(QWidget* picture, const model::SceneDocument& document);
    void place();
    void dismiss();
};

} // namespace crowd::app
