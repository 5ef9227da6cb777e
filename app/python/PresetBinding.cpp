// SPDX-License-Identifier: MIT
#include <utility>

#include <QtCore/QFileInfo>
#include <QtCore/QStringList>
#include <nlohmann/json.hpp>

#include "app/python/Binding.h"
#include "app/python/PythonBrush.h"
#include "model/base/ShownText.h"
#include "model/brush/BrushJson.h"
#include "model/project/PresetFolder.h"

namespace crowd::app {

using namespace model;

/// crowdbrush.Presets: a folder, read whenever it is asked, since others write into it too.
class ScriptPresets
{
public:
    /// Empty: the editor's own.
    explicit ScriptPresets(QString folder) : m_folder(std::move(folder)) {}

    [[nodiscard]] QString path() const { return m_folder.isEmpty() ? presetFolder() : m_folder; }
    [[nodiscard]] PresetFolder read() const { return PresetFolder(path()); }

private:
    QString m_folder;
};

namespace {

QString nameFrom(const std::string& name)
{
    return QString::fromStdString(name).simplified();
}

/// As it can be read again: a script may set what files refuse.
BrushSettings soundSettings(const PythonBrush& brush)
{
    if (!brush.isKnownKind()) {
        throw ScriptError("brush.kind is none of the choices there are.");
    }
    BrushSettings settings = brush.settings();
    (void)valueOrRaise(brushFromJson(brushJson(settings, BrushFields::Portable)));
    return settings;
}

PythonBrush brushIn(const BrushPreset& preset)
{
    return PythonBrush::of(applied(preset, initialBrush(preset.kind)));
}

ScriptError missing(const PresetFolder& folder, const QString& name)
{
    QStringList known;
    for (const BrushPreset& each : folder.all()) {
        known << each.name;
    }
    std::string text =
        "There is no preset \"" + shortened(name.toStdString()) + "\"; there are: " +
        (known.isEmpty() ? "none yet" : known.join(QStringLiteral(", ")).toStdString()) + ".";
    for (const Message& problem : folder.problems()) {
        text += " " + problem.english();
    }
    return ScriptError(text);
}

PythonBrush presetNamed(const ScriptPresets& presets, const std::string& name)
{
    const PresetFolder folder = presets.read();
    const BrushPreset* preset = folder.find(nameFrom(name));
    if (preset == nullptr) {
        throw missing(folder, nameFrom(name));
    }
    return brushIn(*preset);
}

py::object presetOr(const ScriptPresets& presets, const std::string& name, py::object otherwise)
{
    const PresetFolder folder = presets.read();
    const BrushPreset* preset = folder.find(nameFrom(name));
    return preset != nullptr ? py::cast(brushIn(*preset)) : std::move(otherwise);
}

void setPreset(const ScriptPresets& presets, const std::string& name, const PythonBrush& brush)
{
    valueOrRaise(presets.read().save(nameFrom(name), soundSettings(brush)));
}

void removePreset(const ScriptPresets& presets, const std::string& name)
{
    PresetFolder folder = presets.read();
    if (folder.find(nameFrom(name)) == nullptr) {
        throw missing(folder, nameFrom(name));
    }
    valueOrRaise(folder.remove(nameFrom(name)));
}

/// What `each` makes of them, in the order of the panel.
template<class Each>
py::list listOf(const ScriptPresets& presets, const Each& each)
{
    py::list all;
    const PresetFolder folder = presets.read();
    for (const BrushPreset& preset : folder.all()) {
        all.append(each(preset));
    }
    return all;
}

py::list namesOf(const ScriptPresets& presets)
{
    return listOf(presets,
                  [](const BrushPreset& each) { return py::str(each.name.toStdString()); });
}

using PresetsClass = py::class_<ScriptPresets>;

void bindMapping(PresetsClass& type)
{
    type.def("__len__", [](const ScriptPresets& presets) { return presets.read().all().size(); })
        .def("__iter__", [](const ScriptPresets& presets) { return py::iter(namesOf(presets)); })
        .def(
            "__contains__",
            [](const ScriptPresets& presets, const std::string& name) {
                return presets.read().find(nameFrom(name)) != nullptr;
            },
            py::arg("name"))
        .def("__getitem__", &presetNamed, py::arg("name"), "Raises Error where there is none.")
        .def("__setitem__", &setPreset, py::arg("name"), py::arg("brush"),
             "Writes it; takes the place of the one with that name.")
        .def("__delitem__", &removePreset, py::arg("name"),
             "Its file goes into the system's trash. Raises Error where there is none.")
        .def("get", &presetOr, py::arg("name"), py::arg("default") = py::none(),
             "The brush, or default where there is none of that name.")
        .def("keys", &namesOf, "Their names, sorted as in the panel.")
        .def(
            "values",
            [](const ScriptPresets& presets) {
                return listOf(presets, [](const BrushPreset& each) { return brushIn(each); });
            },
            "Their brushes, in that order.")
        .def(
            "items",
            [](const ScriptPresets& presets) {
                return listOf(presets, [](const BrushPreset& each) {
                    return py::make_tuple(each.name.toStdString(), brushIn(each));
                });
            },
            "(name, brush) of each, in that order.");
}

PythonBrush loadPreset(const FilePath& path)
{
    return brushIn(valueOrRaise(readPreset(QString::fromStdString(path.string()))));
}

void savePreset(const PythonBrush& brush, const FilePath& path,
                const std::optional<std::string>& name)
{
    const QString file = QString::fromStdString(path.string());
    const QString named = name ? nameFrom(*name) : QFileInfo(file).completeBaseName();
    valueOrRaise(writePreset(presetOf(named, soundSettings(brush)), file));
}

/// Single files, as members of the brush.
void bindFiles(py::module_& module)
{
    py::class_<PythonBrush> brush(module.attr("Brush"));
    brush
        .def_static("load", &loadPreset, py::arg("path"),
                    "The brush of a .brush file, as the panel of presets saves them. Raises Error "
                    "with the file, the place in it and what to do.")
        .def("save", &savePreset, py::arg("path"), py::arg("name") = py::none(),
             "Writes a .brush file, whole or not at all; name: what the panel calls it, else as "
             "the file. What means something in one scene alone is not in it: see Presets.");
}

} // namespace

void bindPresets(py::module_& module)
{
    PresetsClass type(
        module, "Presets",
        "Brushes kept under names, one .brush file each in a folder, as a mapping: presets[name] "
        "gives a brush, presets[name] = brush keeps one, del presets[name] removes it. "
        "crowdbrush.presets "
        "are the editor's own, and its panel shows at once what is written there. Words of a name "
        "that begin "
        "with # are tags. What means something in one scene alone, such as the group that a brush "
        "puts "
        "people into and the templates that it creates, is not kept: see Brush.to_dict.");
    type.def(py::init([](const std::optional<FilePath>& folder) {
                 return ScriptPresets(folder ? QString::fromStdString(folder->string())
                                             : QString());
             }),
             py::arg("folder") = py::none(),
             "Of a folder, which is made with the first preset; None: where the editor keeps its "
             "own.");
    bindMapping(type);
    type.def_property_readonly(
            "folder", [](const ScriptPresets& presets) { return presets.path().toStdString(); },
            "Where their files are.")
        .def_property_readonly(
            "problems",
            [](const ScriptPresets& presets) {
                std::vector<std::string> texts;
                const PresetFolder folder = presets.read();
                for (const Message& each : folder.problems()) {
                    texts.push_back(each.english());
                }
                return texts;
            },
            "Which files of the folder cannot be used, and why, in sentences.");
    module.attr("presets") = py::cast(ScriptPresets(QString()));
    bindFiles(module);
}

} // namespace crowd::app
