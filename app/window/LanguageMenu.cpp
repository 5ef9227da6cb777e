// SPDX-License-Identifier: MIT
#include "app/window/LanguageMenu.h"

#include <utility>

#include <QtCore/QCoreApplication>
#include <QtWidgets/QMenu>

#include "app/window/ChoiceMenu.h"
#include "app/window/Language.h"
#include "app/window/PreferencesDialog.h"

namespace crowd::app {

namespace {

constexpr int kWaitMs = 100;

struct LanguageMenuText
{
    Q_DECLARE_TR_FUNCTIONS(LanguageMenu)
};

} // namespace

void fillLanguageMenu(QMenu& menu, const std::function<void(const QString&)>& choose)
{
    ChoiceMenu choices(menu);
    const auto add = [&](const QString& code, const QString& name) {
        choices.add({.name = QStringLiteral("language-") + code,
                     .text = name,
                     .choose = [choose, code] { choose(code); },
                     .isChosen = [code] { return code == languageInUse(); }});
    };
    add({}, LanguageMenuText::tr("As the System"));
    menu.addSeparator();
    for (const Language& language : languages()) {
        add(language.code, language.name);
    }
}

LanguageSwitch::LanguageSwitch(std::function<bool()> isFree, QObject* parent)
    : QObject(parent), m_isFree(std::move(isFree))
{
    m_look.setInterval(kWaitMs);
    connect(&m_look, &QTimer::timeout, this, &LanguageSwitch::take);
}

void LanguageSwitch::choose(const QString& code)
{
    Preferences changed = Preferences::load();
    changed.language = code;
    changed.save();
    m_wanted = code;
    if (!take()) {
        m_look.start();
        Q_EMIT delayed();
    }
}

bool LanguageSwitch::take()
{
    if (m_wanted != languageInUse()) {
        if (!m_isFree()) {
            return false;
        }
        useLanguage(m_wanted);
    }
    m_look.stop();
    return true;
}

} // namespace crowd::app
