// SPDX-License-Identifier: MIT
#include "app/window/ReadyNames.h"

#include <algorithm>
#include <iterator>

#include <QtCore/QCoreApplication>
#include <QtCore/QFileInfo>

namespace crowd::app {

namespace {

constexpr const char* kContext = "ReadyNames";

/// As they are written in resources/scenes.
constexpr const char* kNames[] = {
    // Scenes; a meadow is a camera, too.
    QT_TRANSLATE_NOOP("ReadyNames", "City"),
    QT_TRANSLATE_NOOP("ReadyNames", "Stadium"),
    QT_TRANSLATE_NOOP("ReadyNames", "Theatre"),
    // Cameras.
    QT_TRANSLATE_NOOP("ReadyNames", "Above"),
    QT_TRANSLATE_NOOP("ReadyNames", "Audience"),
    QT_TRANSLATE_NOOP("ReadyNames", "Back row"),
    QT_TRANSLATE_NOOP("ReadyNames", "Beetles"),
    QT_TRANSLATE_NOOP("ReadyNames", "Close"),
    QT_TRANSLATE_NOOP("ReadyNames", "Eye to eye"),
    QT_TRANSLATE_NOOP("ReadyNames", "Fountain"),
    QT_TRANSLATE_NOOP("ReadyNames", "From the bridge"),
    QT_TRANSLATE_NOOP("ReadyNames", "From the side"),
    QT_TRANSLATE_NOOP("ReadyNames", "From the stage"),
    QT_TRANSLATE_NOOP("ReadyNames", "From the top row"),
    QT_TRANSLATE_NOOP("ReadyNames", "Horses"),
    QT_TRANSLATE_NOOP("ReadyNames", "Machines"),
    QT_TRANSLATE_NOOP("ReadyNames", "Meadow"),
    QT_TRANSLATE_NOOP("ReadyNames", "Pitch"),
    QT_TRANSLATE_NOOP("ReadyNames", "Square"),
    QT_TRANSLATE_NOOP("ReadyNames", "Stand"),
    QT_TRANSLATE_NOOP("ReadyNames", "Whole theatre"),
    // Lights.
    QT_TRANSLATE_NOOP("ReadyNames", "Floodlight"),
    QT_TRANSLATE_NOOP("ReadyNames", "Landing pad"),
    QT_TRANSLATE_NOOP("ReadyNames", "Left stand"),
    QT_TRANSLATE_NOOP("ReadyNames", "Middle"),
    QT_TRANSLATE_NOOP("ReadyNames", "Picnic"),
    QT_TRANSLATE_NOOP("ReadyNames", "Right stand"),
    QT_TRANSLATE_NOOP("ReadyNames", "Stage left"),
    QT_TRANSLATE_NOOP("ReadyNames", "Stage right"),
    QT_TRANSLATE_NOOP("ReadyNames", "Street lamp"),
    // States.
    QT_TRANSLATE_NOOP("ReadyNames", "Calm"),
    QT_TRANSLATE_NOOP("ReadyNames", "Cheering"),
    QT_TRANSLATE_NOOP("ReadyNames", "Disappointed"),
};

/// Where " 2" begins in "Street lamp 2".
std::size_t numberOf(const std::string& name)
{
    const std::size_t last = name.find_last_not_of("0123456789");
    const bool isNumbered =
        last != std::string::npos && last + 1 < name.size() && name[last] == ' ';
    return isNumbered ? last : name.size();
}

template<class Items>
void translateEach(Items& items)
{
    for (auto& item : items) {
        item.name = translatedName(item.name).toStdString();
    }
}

} // namespace

bool isReadyName(const std::string& name)
{
    const std::string plain = name.substr(0, numberOf(name));
    return std::find(std::begin(kNames), std::end(kNames), plain) != std::end(kNames);
}

QString translatedName(const std::string& name)
{
    if (!isReadyName(name)) {
        return QString::fromStdString(name);
    }
    const std::size_t number = numberOf(name);
    const std::string plain = name.substr(0, number);
    return QCoreApplication::translate(kContext, plain.c_str()) +
           QString::fromStdString(name.substr(number));
}

QString exampleName(const QString& path)
{
    QString name = QFileInfo(path).completeBaseName().replace(QLatin1Char('_'), QLatin1Char(' '));
    name[0] = name[0].toUpper();
    return translatedName(name.toStdString());
}

void translateNames(model::Scene& scene)
{
    translateEach(scene.cameras);
    translateEach(scene.lights);
    translateEach(scene.states);
}

} // namespace crowd::app
