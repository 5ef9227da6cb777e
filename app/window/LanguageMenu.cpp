// SPDX-License-Identifier: MIT
#include "app/window/LanguageMenu.h"

#include <utility>

#include <QtCore/QCoreApplication>
#include <QtGui/QActionGroup>
#include <QtWidgets/QMenu>

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
    auto* group = new QActionGroup(&menu);
    const auto add = [&](const QString& code, const QString& name) {
        QAction* action = menu.addAction(name);
        action->setObjectName(QStringLiteral("language-") + code);
        action->setCheckable(true);
        action->setChecked(code == languageInUse());
        action->setData(code);
        group->addAction(action);
        QObject::connect(action, &QAction::triggered, &menu, [choose, code] { choose(code); });
    };
    add({}, LanguageMenuText::tr("As the System"));
    menu.addSeparator();
    for (const Language& language : languages()) {
        add(language.code, language.name);
    }
    QObject::connect(&menu, &QMenu::aboutToShow, group, [group] { // one may have been put off
        for (QAction* action : group->actions()) {
            action->setChecked(action->data().toString() == languageInUse());
        }
    });
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
