// SPDX-License-Identifier: MIT
#include "widgets/theme/Theme.h"

#include <QtWidgets/QApplication>

#include "widgets/theme/CrowdStyle.h"

namespace crowd::widgets {

namespace {

struct Shades
{
    QColor window, base, alternate, button, text, disabled, border, accent, accentText;
};

Shades lightShades()
{
    return {{236, 236, 238}, {250, 250, 251}, {242, 242, 244}, {246, 246, 248}, {32, 33, 36},
            {150, 152, 156}, {198, 199, 203}, {196, 98, 24},   {255, 255, 255}};
}

Shades darkShades()
{
    return {{50, 51, 54},    {36, 37, 40}, {43, 44, 47},   {64, 65, 69}, {226, 227, 230},
            {128, 130, 134}, {28, 29, 31}, {232, 132, 50}, {24, 20, 16}};
}

QPalette paletteOf(const Shades& shades)
{
    QPalette palette;
    palette.setColor(QPalette::Window, shades.window);
    palette.setColor(QPalette::Base, shades.base);
    palette.setColor(QPalette::AlternateBase, shades.alternate);
    palette.setColor(QPalette::Button, shades.button);
    palette.setColor(QPalette::ToolTipBase, shades.base);
    palette.setColor(QPalette::Highlight, shades.accent);
    palette.setColor(QPalette::HighlightedText, shades.accentText);
    palette.setColor(QPalette::Link, shades.accent);
    palette.setColor(QPalette::Mid, shades.border);
    palette.setColor(QPalette::Dark, shades.border.darker(120));
    palette.setColor(QPalette::Light, shades.button.lighter(115));
    palette.setColor(QPalette::Midlight, shades.button.lighter(107));
    palette.setColor(QPalette::Shadow, QColor(0, 0, 0, 90));
    palette.setColor(QPalette::PlaceholderText, shades.disabled);
    for (const auto role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
        palette.setColor(role, shades.text);
        palette.setColor(QPalette::Disabled, role, shades.disabled);
    }
    palette.setColor(QPalette::Disabled, QPalette::Highlight, shades.border);
    return palette;
}

/// What is switched on: tinted, so that the icon's own colours stay readable on it.
QColor mixed(const QColor& ground, const QColor& accent)
{
    const auto part = [](int a, int b) { return a + (b - a) * 3 / 10; };
    return {part(ground.red(), accent.red()), part(ground.green(), accent.green()),
            part(ground.blue(), accent.blue())};
}

QString styleSheetOf(const Shades& shades)
{
    return QStringLiteral(R"(
QMainWindow::separator { width: 4px; height: 4px; background: %1; }
QMainWindow::separator:hover { background: %3; }
QDockWidget { font-weight: 600; }
QDockWidget::title { padding: 5px 8px; background: %2; border-bottom: 1px solid %1; }
QToolBar { border: none; spacing: 2px; padding: 3px; background: %2; }
QToolButton { border: 1px solid transparent; border-radius: 4px; padding: 3px; }
QToolButton:hover { border-color: %1; background: %4; }
QToolButton:checked { background: %5; border-color: %3; }
QStatusBar::item { border: none; }
QToolTip { border: 1px solid %1; padding: 3px; }
QGroupBox { font-weight: 600; border: none; margin-top: 18px; }
QGroupBox::title { subcontrol-origin: margin; left: 0px; padding: 2px 0px; }
)")
        .arg(shades.border.name(), shades.window.name(), shades.accent.name(), shades.button.name(),
             mixed(shades.window, shades.accent).name());
}

} // namespace

QString themeName(Theme theme)
{
    switch (theme) {
    case Theme::Light:
        return QStringLiteral("light");
    case Theme::Dark:
        return QStringLiteral("dark");
    case Theme::System:
        break;
    }
    return QStringLiteral("system");
}

Theme themeNamed(const QString& name)
{
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
        if (name == themeName(theme)) {
            return theme;
        }
    }
    return Theme::System;
}

bool isDark(const QPalette& palette)
{
    return palette.color(QPalette::Window).lightness() < 128;
}

void applyTheme(Theme theme)
{
    // Asked once, before the first palette of ours: Qt 6.4 cannot ask the system itself.
    static const bool isSystemDark = isDark(QApplication::palette());
    const bool dark = theme == Theme::Dark || (theme == Theme::System && isSystemDark);
    const Shades shades = dark ? darkShades() : lightShades();
    const QString sheet = styleSheetOf(shades);
    if (qApp->styleSheet() == sheet) {
        return; // every widget there is would be polished anew: a second, for nothing
    }
    QApplication::setStyle(new CrowdStyle); // the application owns it
    QApplication::setPalette(paletteOf(shades));
    qApp->setStyleSheet(sheet);
}

} // namespace crowd::widgets
