// SPDX-License-Identifier: MIT
#include "app/window/PassFields.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QSettings>
#include <QtCore/QStringList>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QGridLayout>

namespace crowd::app {

namespace {

QString passName(const PicturePass& pass)
{
    return QString::fromUtf8(pass.key.data(), static_cast<int>(pass.key.size()));
}

} // namespace

PassFields::PassFields(QString settingsKey, QWidget* parent)
    : QWidget(parent), m_settingsKey(std::move(settingsKey))
{
    constexpr int kColumns = 3;
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins({});
    const QStringList last = QSettings().value(m_settingsKey).toStringList();
    for (const PicturePass& pass : picturePasses()) {
        if (pass.need == PassNeed::Colours) {
            continue; // the picture itself
        }
        auto* box = new QCheckBox(QCoreApplication::translate("PicturePasses", pass.label), this);
        box->setObjectName(QStringLiteral("picturePass.") + passName(pass));
        box->setToolTip(pass.samples != nullptr
                            ? tr("For compositing: a layer of an OpenEXR file, or a PNG of its own "
                                 "beside that of the colours")
                            : tr("For compositing: layers of an OpenEXR file alone"));
        box->setChecked(last.contains(passName(pass)));
        const int place = static_cast<int>(m_boxes.size());
        grid->addWidget(box, place / kColumns, place % kColumns);
        m_boxes.emplace_back(&pass, box);
    }
}

PicturePasses PassFields::chosen() const
{
    PicturePasses passes{&picturePasses().front()};
    for (const auto& [pass, box] : m_boxes) {
        if (box->isChecked()) {
            passes.push_back(pass);
        }
    }
    return passes.size() > 1 ? passes : PicturePasses();
}

void PassFields::remember() const
{
    QStringList keys;
    for (const auto& [pass, box] : m_boxes) {
        if (box->isChecked()) {
            keys << passName(*pass);
        }
    }
    QSettings().setValue(m_settingsKey, keys);
}

} // namespace crowd::app
