// SPDX-License-Identifier: MIT
#include "widgets/forms/FieldReferences.h"

#include <algorithm>
#include <set>
#include <string_view>

#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

#include "model/brush/BrushSettings.h"
#include "model/brush/ClipChoice.h"
#include "model/rules/RuleSets.h"
#include "model/scene/NearestPath.h"
#include "model/scene/Scene.h"
#include "widgets/forms/CheckList.h"
#include "widgets/forms/ClipMix.h"
#include "widgets/forms/ClipPopup.h"
#include "widgets/forms/FieldNames.h"
#include "widgets/forms/PointPicking.h"
#include "widgets/state/BrushTexts.h"
#include "widgets/state/Cues.h"
#include "widgets/state/EditorState.h"
#include "widgets/state/FeatureTexts.h"

namespace crowd::widgets {

using Bound = FieldForm::Bound;

namespace {

constexpr int kTagsOffered = 8; ///< without a name

const model::Scene& sceneOf(const FieldForm& form)
{
    static const model::Scene kNone;
    const model::Scene* scene = form.context().scene;
    return scene != nullptr ? *scene : kNone;
}

QString labelText(const Bound& bound)
{
    return fieldText(bound.field->meta.label);
}

/// Names of all slots of the scene's templates, each once.
std::vector<std::string> slotNames(const model::Scene& scene)
{
    std::vector<std::string> names;
    std::set<std::string> known;
    for (const model::TemplateEntry& entry : scene.templates) {
        for (std::size_t i = 0; entry.asset && i < entry.asset->slots.size(); ++i) {
            if (known.insert(entry.asset->slots[i].name).second) {
                names.push_back(entry.asset->slots[i].name);
            }
        }
    }
    return names;
}

/// The flag beside a slot that means the clothes as a whole; null: there is none.
const model::FieldInfo* sparingField(const FieldForm& form)
{
    const model::BrushSettings* brush = form.context().brush;
    if (brush == nullptr) {
        return nullptr;
    }
    const auto fields = model::brushType(brush->kind()).fields;
    const auto found = std::ranges::find_if(fields, [](const model::FieldInfo& field) {
        return std::string_view(field.meta.key) == "spares_body";
    });
    return found != fields.end() ? &*found : nullptr;
}

/// Where a flag says so, the clothes as a whole come before all slots and each of them.
void addSlot(FieldForm& form, const Bound& bound)
{
    const std::vector<std::string> names = slotNames(sceneOf(form));
    const model::FieldInfo* sparing = sparingField(form);
    const int wholes = sparing != nullptr ? 2 : 1;
    QStringList texts;
    if (sparing != nullptr) {
        texts << FieldForm::tr("Clothes");
    }
    texts << (sparing != nullptr ? FieldForm::tr("All tintable") : FieldForm::tr("All"));
    for (const std::string& name : names) {
        texts << QString::fromStdString(name);
    }
    const auto chosen = [&form, bound, names, sparing, wholes] {
        const auto found = std::ranges::find(names, form.valueOf<std::string>(bound));
        if (found != names.end()) {
            return static_cast<int>(found - names.begin()) + wholes;
        }
        return sparing != nullptr && !std::get<bool>(sparing->get(form.object(bound))) ? 1 : 0;
    };
    const auto choose = [&form, bound, names, sparing, wholes](int i) {
        form.change(bound, [&](void* object) {
            if (sparing != nullptr) {
                sparing->set(object, i == 0);
            }
            bound.field->set(object, i < wholes ? std::string()
                                                : names[static_cast<std::size_t>(i - wholes)]);
        });
    };
    form.addChoice(labelText(bound), texts, chosen, choose, bound.isShown);
}

/// Names of materials that some slot lets choose from, each once; any comes first.
void addMaterial(FieldForm& form, const Bound& bound)
{
    QStringList texts{FieldForm::tr("Any, by the operator")};
    std::vector<std::string> names{std::string()};
    for (const model::TemplateEntry& entry : sceneOf(form).templates) {
        for (std::size_t i = 0; entry.asset && i < entry.asset->slots.size(); ++i) {
            const auto& choices = entry.asset->slots[i].choices;
            for (std::size_t c = 0; choices.size() > 1 && c < choices.size(); ++c) {
                if (std::ranges::find(names, choices[c].name) == names.end()) {
                    names.push_back(choices[c].name);
                    texts << QString::fromStdString(choices[c].name);
                }
            }
        }
    }
    addName(form, bound, texts, names);
}

/// Names of the parts of the scene's templates, each once; all comes first.
void addPart(FieldForm& form, const Bound& bound)
{
    QStringList texts{FieldForm::tr("All parts")};
    std::vector<std::string> names{std::string()};
    for (const model::TemplateEntry& entry : sceneOf(form).templates) {
        for (std::size_t i = 0; entry.asset && i < entry.asset->parts.size(); ++i) {
            const std::string& name = entry.asset->parts[i].name;
            if (std::ranges::find(names, name) == names.end()) {
                names.push_back(name);
                texts << QString::fromStdString(name);
            }
        }
    }
    addName(form, bound, texts, names);
}

/// How a body is in a clip; in the order in which they are offered.
enum class ClipBearing { Standing, Walking, Sitting };

ClipBearing bearingOf(const model::TemplateEntry& entry, int clip, bool isMoving)
{
    if (clip >= 0 && entry.asset->clips[static_cast<std::size_t>(clip)].seatHeight) {
        return ClipBearing::Sitting;
    }
    return isMoving ? ClipBearing::Walking : ClipBearing::Standing;
}

/// Each name once, as the first template has it; those to walk with, or all.
std::vector<ClipMix::Section> clipSections(const model::Scene& scene, bool areWalking)
{
    std::vector<ClipMix::Section> sections{{FieldForm::tr("Standing"), {}},
                                           {FieldForm::tr("Walking"), {}},
                                           {FieldForm::tr("Sitting"), {}}};
    std::set<std::string> known;
    for (const model::TemplateEntry& entry : scene.templates) {
        for (std::size_t i = 0; i < entry.clipNames.size(); ++i) {
            const int index = entry.asset ? entry.asset->clipIndex(entry.clipNames[i]) : -1;
            const bool isMoving =
                index >= 0 && model::movesOverGround(entry, i, static_cast<std::size_t>(index));
            const ClipBearing bearing = bearingOf(entry, index, isMoving);
            if ((isMoving || !areWalking) && known.insert(entry.clipNames[i]).second) {
                sections[static_cast<std::size_t>(bearing)].names.push_back(entry.clipNames[i]);
            }
        }
    }
    std::erase_if(sections, [](const ClipMix::Section& section) { return section.names.empty(); });
    return sections;
}

void addClips(FieldForm& form, const Bound& bound)
{
    const bool areWalking = bound.field->meta.role == model::FieldRole::WalkingClips;
    auto* mix = new ClipMix(clipSections(sceneOf(form), areWalking), &form);
    if (form.state() != nullptr) {
        ClipPopup::attach(*mix, *form.state());
    }
    addMix(form, bound, mix);
}

void addPath(FieldForm& form, const Bound& bound)
{
    QStringList names{FieldForm::tr("None: stay"), FieldForm::tr("The nearest")};
    std::vector<std::int64_t> ids{0, model::kNearestPath};
    for (const model::Path& path : sceneOf(form).paths) {
        names << QString::fromStdString(path.name);
        ids.push_back(path.id);
    }
    form.addChoice(
        labelText(bound), names,
        [&form, bound, ids] {
            const auto found = std::ranges::find(ids, form.valueOf<std::int64_t>(bound));
            return found == ids.end() ? 0 : static_cast<int>(found - ids.begin());
        },
        [&form, bound, ids](int i) { form.setValue(bound, ids[static_cast<std::size_t>(i)]); },
        bound.isShown);
}

/// One of the entries of the scene, or none.
template<class Entry>
void addEntryChoice(FieldForm& form, const Bound& bound, const std::vector<Entry>& entries)
{
    QStringList names{fieldText(bound.field->meta.zero)};
    std::vector<std::int64_t> ids{0};
    for (const Entry& entry : entries) {
        names << QString::fromStdString(entry.name);
        ids.push_back(entry.id);
    }
    form.addChoice(
        labelText(bound), names,
        [&form, bound, ids] {
            const auto found = std::ranges::find(ids, form.valueOf<std::int64_t>(bound));
            return found == ids.end() ? -1 : static_cast<int>(found - ids.begin());
        },
        [&form, bound, ids](int i) { form.setValue(bound, ids[static_cast<std::size_t>(i)]); },
        bound.isShown);
}

/// Where no path has a meaning of its own, following one does not.
void addAnyPath(FieldForm& form, const Bound& bound)
{
    if (*bound.field->meta.zero != 0) {
        addEntryChoice(form, bound, sceneOf(form).paths);
    } else {
        addPath(form, bound);
    }
}

/// What a list of ids may hold, by its role.
std::vector<CheckList::Item> listedItems(const model::Scene& scene, model::FieldRole role)
{
    std::vector<CheckList::Item> items;
    if (role == model::FieldRole::Template) {
        for (const model::TemplateEntry& entry : scene.templates) {
            items.push_back({entry.id, QString::fromStdString(entry.name)});
        }
    } else if (role == model::FieldRole::Group) {
        items.push_back({0, FieldForm::tr("In no group")});
        for (const model::Group& group : scene.groups) {
            items.push_back({static_cast<int>(group.id), QString::fromStdString(group.name)});
        }
    } else if (role == model::FieldRole::Feature) {
        for (const model::NamedFeature& each : featureEntries(scene)) {
            items.push_back({static_cast<int>(each.id), QString::fromStdString(each.name)});
        }
    } else {
        for (int bit = 0; bit < static_cast<int>(model::kTagCount); ++bit) {
            const auto named = std::ranges::find(scene.tags, bit, &model::TagName::bit);
            if (named != scene.tags.end() || bit < kTagsOffered) {
                items.push_back({bit, tagText(scene, bit)});
            }
        }
    }
    return items;
}

void addCheckList(FieldForm& form, const Bound& bound)
{
    auto* list = new CheckList(fieldText(bound.field->meta.zero), &form);
    list->setToolTip(fieldText(bound.field->meta.tip));
    const model::FieldRole role = bound.field->meta.role;
    list->setSource([&form, role] { return listedItems(sceneOf(form), role); });
    QObject::connect(list, &CheckList::edited, &form,
                     [&form, bound](const std::vector<int>& ids) { form.setValue(bound, ids); });
    form.addLabelled(
        labelText(bound), list,
        [&form, list, bound] { list->setChecked(form.valueOf<std::vector<int>>(bound)); },
        bound.isShown);
}

/// A colour and a name beside it, to be looked at only.
void addTagSwatch(FieldForm& form, const Bound& bound)
{
    auto* row = new QWidget(&form);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* swatch = new QLabel(row);
    swatch->setObjectName(QStringLiteral("swatch"));
    auto* name = new QLabel(row);
    name->setObjectName(QStringLiteral("swatchText"));
    name->setWordWrap(true);
    layout->addWidget(swatch);
    layout->addWidget(name, 1);
    form.bind(
        row,
        [&form, swatch, name, bound] {
            const model::Scene& scene = sceneOf(form);
            const auto tag = static_cast<int>(form.valueOf<std::int64_t>(bound));
            QPixmap filled(14, 14);
            filled.fill(widgets::tagColor(scene, tag));
            swatch->setPixmap(filled);
            const auto named = std::ranges::find(scene.tags, tag, &model::TagName::bit);
            name->setText(named != scene.tags.end() && !named->name.empty()
                              ? QString::fromStdString(named->name)
                              : FieldForm::tr("no name yet; the Rules panel gives it one"));
        },
        bound.isShown);
}

void addTag(FieldForm& form, const Bound& bound)
{
    form.addSlider(
        labelText(bound), {1.0, model::kTagCount, 1.0, 0, {}, false},
        [&form, bound] { return static_cast<double>(form.valueOf<std::int64_t>(bound)) + 1.0; },
        [&form, bound](double shown) {
            form.setValue(bound, static_cast<std::int64_t>(shown - 1.0));
        },
        bound.isShown);
    addTagSwatch(form, bound);
    QStringList names;
    std::vector<std::int64_t> bits;
    for (const model::TagName& tag : sceneOf(form).tags) {
        names << QString::fromStdString(tag.name);
        bits.push_back(tag.bit);
    }
    if (bits.empty()) {
        return;
    }
    form.addChoice(
        FieldForm::tr("Named"), names,
        [&form, bound, bits] {
            const auto found = std::ranges::find(bits, form.valueOf<std::int64_t>(bound));
            return found == bits.end() ? -1 : static_cast<int>(found - bits.begin());
        },
        [&form, bound, bits](int i) { form.setValue(bound, bits[static_cast<std::size_t>(i)]); },
        bound.isShown);
}

/// Cues without a name are called after what they do.
std::vector<model::Cue> namedCues(const model::Scene& scene)
{
    std::vector<model::Cue> cues = scene.cues;
    for (model::Cue& cue : cues) {
        cue.name = cueTitle(scene, cue).toStdString();
    }
    return cues;
}

/// One of the groups, states or cues that there are.
void addEntry(FieldForm& form, const Bound& bound)
{
    const model::Scene& scene = sceneOf(form);
    if (bound.field->meta.role == model::FieldRole::Group) {
        addEntryChoice(form, bound, scene.groups);
    } else if (bound.field->meta.role == model::FieldRole::State) {
        addEntryChoice(form, bound, scene.states);
    } else {
        addEntryChoice(form, bound, namedCues(scene));
    }
}

/// Events that some rule listens to, beside a text of the artist's own.
void addKnownEvents(FieldForm& form, const Bound& bound)
{
    QStringList names;
    for (const std::string& event : model::eventsOf(sceneOf(form))) {
        names << QString::fromStdString(event);
    }
    if (names.isEmpty()) {
        return;
    }
    form.addChoice(
        FieldForm::tr("Known"), names,
        [&form, bound, names] {
            return static_cast<int>(
                names.indexOf(QString::fromStdString(form.valueOf<std::string>(bound))));
        },
        [&form, bound, names](int i) { form.setValue(bound, names[i].toStdString()); },
        bound.isShown);
}

/// Sliders for some of the axes, side by side.
void addAxes(FieldForm& form, const Bound& bound, std::initializer_list<int> axes)
{
    const model::FieldMeta& meta = bound.field->meta;
    form.beginRow();
    for (const int axis : axes) {
        form.addSlider(
            axis == 0   ? QStringLiteral("X")
            : axis == 1 ? FieldForm::tr("Height")
                        : QStringLiteral("Z"),
            {meta.sliderLow, meta.sliderHigh, meta.step, meta.decimals, fieldText(meta.unit),
             false},
            [&form, bound, axis] {
                return static_cast<double>(form.valueOf<glm::vec3>(bound)[axis]);
            },
            [&form, bound, axis](double shown) {
                auto point = form.valueOf<glm::vec3>(bound);
                point[axis] = static_cast<float>(shown);
                form.setValue(bound, point);
            },
            bound.isShown);
    }
    form.endRow();
}

/// Its height comes with the point that is chosen in the picture.
void addPoint(FieldForm& form, const Bound& bound)
{
    addAxes(form, bound, {0, 2});
    EditorState* state = form.state();
    if (state == nullptr) {
        return;
    }
    auto* button = new QPushButton(FieldForm::tr("Choose in the Picture"), &form);
    button->setToolTip(FieldForm::tr("Then click the point"));
    makePointButton(*button, *state,
                    [&form, bound](const glm::vec3& point) { form.setValue(bound, point); });
    auto* mark =
        new PointMark(*button, *state, [&form, bound] { return form.valueOf<glm::vec3>(bound); });
    form.bind(
        button, [mark] { mark->refresh(); }, bound.isShown);
}

/// A point in the air: nothing is there to click on.
void addSpace(FieldForm& form, const Bound& bound)
{
    auto* title = new QLabel(labelText(bound), &form);
    title->setToolTip(fieldText(bound.field->meta.tip));
    form.bind(
        title, [] {}, bound.isShown);
    addAxes(form, bound, {0, 2});
    addAxes(form, bound, {1}); // all three would be too wide
}

/// Whoever is selected when the button is pressed.
void addIndividual(FieldForm& form, const Bound& bound)
{
    auto* button = new QPushButton(&form);
    button->setObjectName(QStringLiteral("takeSelected"));
    button->setToolTip(FieldForm::tr("Take whoever is selected"));
    if (EditorState* state = form.state()) {
        QObject::connect(button, &QPushButton::clicked, &form, [state, &form, bound] {
            const auto ids = state->selection().ids();
            if (ids.empty()) {
                state->showStatus(FieldForm::tr("Nobody is selected: click somebody first."));
            } else {
                form.setValue(bound, static_cast<std::int64_t>(ids.front()));
            }
        });
    }
    form.addLabelled(
        labelText(bound), button,
        [&form, button, bound] {
            const auto id = static_cast<model::IndividualId>(form.valueOf<std::int64_t>(bound));
            const bool isThere = sceneOf(form).population.rowOf(id) != model::Population::npos;
            button->setText(id == 0   ? FieldForm::tr("Take the Selected")
                            : isThere ? FieldForm::tr("Character %1").arg(id)
                                      : FieldForm::tr("Character %1, who is gone").arg(id));
        },
        bound.isShown);
}

/// What is somewhere in the scene.
void addInScene(FieldForm& form, const Bound& bound)
{
    if (bound.field->meta.role == model::FieldRole::Point) {
        addPoint(form, bound);
    } else if (bound.field->meta.role != model::FieldRole::Individual) {
        addSpace(form, bound);
    } else {
        addIndividual(form, bound);
    }
}

} // namespace

bool addReferenceControl(FieldForm& form, const Bound& bound)
{
    const model::FieldInfo& field = *bound.field;
    if (addNamedControl(form, bound)) {
        return true;
    }
    if (field.is<std::vector<model::ClipWeight>>()) {
        addClips(form, bound);
        return true;
    }
    if (field.is<std::vector<int>>() && field.meta.role != model::FieldRole::SeatNumbers) {
        addCheckList(form, bound);
        return true;
    }
    switch (field.meta.role) {
    case model::FieldRole::Group:
    case model::FieldRole::State:
    case model::FieldRole::Cue:
        addEntry(form, bound);
        return true;
    case model::FieldRole::Slot:
        addSlot(form, bound);
        return true;
    case model::FieldRole::Material:
        addMaterial(form, bound);
        return true;
    case model::FieldRole::Part:
        addPart(form, bound);
        return true;
    case model::FieldRole::Path:
        addAnyPath(form, bound);
        return true;
    case model::FieldRole::Tag:
        addTag(form, bound);
        return true;
    case model::FieldRole::Point:
    case model::FieldRole::Space:
    case model::FieldRole::Target:
    case model::FieldRole::Individual:
        addInScene(form, bound);
        return true;
    case model::FieldRole::Event:
        addKnownEvents(form, bound);
        return false; // and the text
    default:
        return false;
    }
}

} // namespace crowd::widgets
