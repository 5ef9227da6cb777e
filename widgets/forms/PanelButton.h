// SPDX-License-Identifier: MIT
#pragma once

class QString;
class QToolButton;
class QWidget;

namespace crowd::widgets {

inline constexpr int kPanelIcon = 20; ///< logical pixels

/// A flat button with a symbol, as the rows of panels have them.
[[nodiscard]] QToolButton* panelButton(QWidget* parent, const char* icon, const QString& tip,
                                       const char* name);

} // namespace crowd::widgets
