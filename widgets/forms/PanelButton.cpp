// SPDX-License-Identifier: MIT
#include "widgets/forms/PanelButton.h"

#include <QtWidgets/QToolButton>

#include "widgets/theme/Icons.h"

namespace crowd::widgets {

QToolButton* panelButton(QWidget* parent, const char* icon, const QString& tip, const char* name)
{
    auto* button = new QToolButton(parent);
    button->setObjectName(QLatin1String(name));
    button->setIcon(iconNamed(icon));
    button->setIconSize({kPanelIcon, kPanelIcon});
    button->setToolTip(tip);
    button->setAutoRaise(true);
    return button;
}

} // namespace crowd::widgets
