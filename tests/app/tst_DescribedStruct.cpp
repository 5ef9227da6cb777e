// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <QtTest/QTest>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QToolButton>
#include <nlohmann/json.hpp>

#include "app/python/EmbeddedPython.h"
#include "app/python/FieldBinding.h"
#include "app/record/FieldScript.h"
#include "model/describe/FieldChecks.h"
#include "model/describe/FieldJson.h"
#include "tests/program/WindowTest.h"
#include "widgets/forms/ClipMix.h"
#include "widgets/forms/CurveEditor.h"
#include "widgets/forms/FieldForm.h"
#include "widgets/forms/RangeSlider.h"
#include "widgets/forms/ValueSlider.h"

using namespace crowd;
using namespace crowd::model;

namespace {

enum class Glass : std::uint8_t { Clear, Frosted, Coloured };

constexpr FieldChoice kGlasses[] = {
    {"clear", "Clear"}, {"frosted", "Frosted"}, {"coloured", "Coloured"}};

enum class Hang : std::uint8_t { Stands, Hangs };

/// Nothing in the program knows these two.
struct Pole
{
    float height = 3.0F;

    static constexpr auto fields()
    {
        return std::tuple(
            field(&Pole::height, {.key = "height", .label = "Height", .low = 1.0, .high = 9.0}));
    }
    friend bool operator==(const Pole&, const Pole&) = default;
};

/// A member of every type that a value can have.
struct Lantern
{
    bool isLit = false;
    std::uint16_t bulbs = 1;
    Glass glass = Glass::Clear;
    float watts = 40.0F;
    double price = 12.5;
    std::string maker = "none";
    PaintColor color{255, 240, 200};
    Tint shade{10, 20, 30, 40};
    ValueRange flicker{0.25F, 0.5F};
    glm::vec3 place{0.0F};
    glm::quat leaning{1.0F, 0.0F, 0.0F, 0.0F};
    Hang hang = Hang::Stands;
    std::optional<bool> isWanted;
    std::vector<int> hours;
    std::vector<PaintColor> ribbons;
    std::vector<ClipWeight> dances;
    std::vector<TemplateWeight> guests;
    DistributionCurve glow;
    Pole pole;

    static constexpr auto fields()
    {
        using L = Lantern;
        return std::tuple(
            field(&L::isLit, {.key = "is_lit", .label = "Lit"}),
            field(&L::bulbs, {.key = "bulbs", .label = "Bulbs", .low = 1.0, .high = 12.0}),
            field(&L::glass, {.key = "glass", .label = "Glass", .choices = kGlasses}),
            field(&L::watts, {.key = "watts", .label = "Watts", .low = 1.0, .high = 100.0}),
            field(&L::price, {.key = "price", .label = "Price", .low = 0.0, .high = 99.0}),
            field(&L::maker, {.key = "maker", .label = "Maker"}),
            field(&L::color, {.key = "color", .label = "Colour"}),
            field(&L::shade, {.key = "shade", .label = "Shade"}),
            field(&L::flicker, {.key = "flicker", .label = "Flicker"}),
            field(&L::place, {.key = "place",
                              .label = "Place",
                              .low = -99.0,
                              .high = 99.0,
                              .role = FieldRole::Point}),
            field(&L::leaning, {.key = "leaning"}),
            stored<L, bool>([](const L& s) { return s.hang == Hang::Hangs; },
                            [](L& s, bool is) { s.hang = is ? Hang::Hangs : Hang::Stands; },
                            {.key = "hangs"}),
            field(&L::isWanted, {.key = "is_wanted", .label = "Wanted"}),
            field(&L::hours, {.key = "hours", .label = "Hours", .high = 23.0}),
            field(&L::ribbons, {.key = "ribbons", .label = "Ribbons"}),
            field(&L::dances, {.key = "dances", .label = "Dances", .high = 5.0}),
            field(&L::guests, {.key = "guests", .label = "Guests", .high = 5.0}),
            field(&L::glow, {.key = "glow", .label = "Glow"}), field(&L::pole, {.key = "pole"}),
            computed<L, float>([](const L& s) { return s.watts * static_cast<float>(s.bulbs); },
                               [](L& s, float all) { s.watts = all / static_cast<float>(s.bulbs); },
                               {.key = "all_watts", .label = "Together", .high = 1200.0}));
    }
    friend bool operator==(const Lantern&, const Lantern&) = default;
};

/// Inside another: what files may say of it that nobody knows.
struct Flag
{
    int stripes = 3;
    std::string unknownMembers{};

    static constexpr auto fields()
    {
        return std::tuple(field(&Flag::stripes, {.key = "stripes", .high = 9.0}));
    }
    friend bool operator==(const Flag&, const Flag&) = default;
};

struct Tent
{
    float ridge = 2.0F;
    float pegs = 8.0F;

    static constexpr auto fields()
    {
        return std::tuple(
            field(&Tent::ridge, {.key = "ridge", .high = 9.0}),
            field(&Tent::pegs, {.key = "pegs", .high = 99.0})
                .when([](const Tent& s, const FieldContext&) { return s.ridge > 1.0F; }));
    }
};

/// One kind of which is a tent.
struct Shelter : Tent
{
    bool isTent = true;
    Flag flag;

    static constexpr auto fields()
    {
        using S = Shelter;
        return std::tuple(
            field(&S::isTent, {.key = "is_tent"}),
            inherited<S, Tent>([](const S& s, const FieldContext&) { return s.isTent; }),
            field(&S::flag, {.key = "flag", .isBrief = true}));
    }
};

/// Different in every field.
Lantern changedLantern()
{
    Lantern lantern;
    lantern.isLit = true;
    lantern.bulbs = 7;
    lantern.glass = Glass::Coloured;
    lantern.watts = 60.1F;
    lantern.price = 1.0 / 3.0;
    lantern.maker = "Müller \"& Söhne\"\n";
    lantern.color = {1, 2, 3};
    lantern.shade = {4, 5, 6, 7};
    lantern.flicker = {0.1F, 0.7F};
    lantern.place = {1.5F, -2.25F, 0.1F};
    lantern.leaning = {0.5F, 0.5F, -0.5F, 0.5F};
    lantern.hang = Hang::Hangs;
    lantern.isWanted = false;
    lantern.hours = {7, 22, 23};
    lantern.ribbons = {{9, 8, 7}, {6, 5, 4}};
    lantern.dances = {{"waltz", 2.0F}, {"tango", 0.5F}};
    lantern.guests = {{3, 1.5F}, {9, 0.25F}};
    lantern.glow.weights.back() = 0.125F;
    lantern.pole.height = 4.2F;
    return lantern;
}

/// A form of a lantern that writes into it.
class LanternForm
{
public:
    explicit LanternForm(const FieldInfo* only = nullptr)
        : m_form({[this] { return &lantern; },
                  [this](const std::function<void(void*)>& change) {
                      change(&lantern);
                      m_form.refresh();
                  },
                  [this] {
                      return FieldContext{&m_scene, nullptr};
                  }},
                 QStringLiteral("lantern"), nullptr, nullptr)
    {
        m_scene.templates.emplace_back().clipNames = {"waltz", "tango"};
        if (only != nullptr) {
            m_form.addField(*only, {}, {});
        } else {
            m_form.addFields(fieldsOf<Lantern>());
        }
        m_form.finish();
    }
    /// The nth of its controls of a class.
    template<class Control>
    [[nodiscard]] Control& control(int nth = 0) const
    {
        return *m_form.findChildren<Control*>().at(nth);
    }
    [[nodiscard]] bool isEmpty() const { return m_form.findChildren<QWidget*>().isEmpty(); }

    Lantern lantern;

private:
    Scene m_scene;
    widgets::FieldForm m_form;
};

const FieldInfo& fieldNamed(const char* key)
{
    const auto fields = fieldsOf<Lantern>();
    return *std::ranges::find_if(
        fields, [key](const FieldInfo& each) { return std::string_view(each.meta.key) == key; });
}

} // namespace

/// A struct that this test describes works in forms, files, scripts and recordings, without a line
/// about it anywhere else.
class tst_DescribedStruct : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        m_python = std::make_unique<app::EmbeddedPython>(false);
        auto module = app::py::module_::import("crowdbrush");
        app::bindStruct<Pole, Pole>(module, "Pole", "", fieldsOf<Pole>());
        app::bindStruct<Lantern, Lantern>(module, "Lantern", "", fieldsOf<Lantern>());
    }
    void cleanupTestCase() { m_python.reset(); }

    void hasAMemberOfEveryType()
    {
        std::set<std::size_t> types;
        for (const FieldInfo& each : fieldsOf<Lantern>()) {
            types.insert(each.type);
        }
        types.erase(std::variant_npos); // of the pole
        QCOMPARE(types.size(), std::variant_size_v<FieldValue>);
    }

    void isWrittenToJsonAndReadBack()
    {
        const Lantern written = changedLantern();
        nlohmann::json object = nlohmann::json::object();
        addFields(object, fieldsOf<Lantern>(), &written);
        QVERIFY(!object.contains("all_watts"));
        const nlohmann::json parsed = nlohmann::json::parse(object.dump());
        Lantern read;
        Message problem;
        JsonFields source(parsed, "lantern", problem);
        readFields(source, fieldsOf<Lantern>(), &read);
        QVERIFY(source.isSound());
        QVERIFY(source.unknown().empty());
        QVERIFY(read == written);
    }

    void hasTheFieldsOfWhatItIs()
    {
        const auto fields = fieldsOf<Shelter>();
        QCOMPARE(fields.size(), std::size_t{4});
        Shelter shelter;
        fields[1].set(&shelter, 5.0F);
        QCOMPARE(shelter.ridge, 5.0F);
        QVERIFY(fields[1].isShown(&shelter, {}) && fields[2].isShown(&shelter, {}));
        shelter.ridge = 0.5F;
        QVERIFY(fields[1].isShown(&shelter, {}) && !fields[2].isShown(&shelter, {}));
        shelter.isTent = false;
        QVERIFY(!fields[1].isShown(&shelter, {}));
        nlohmann::json object = nlohmann::json::object();
        addFields(object, fields, &shelter);
        QCOMPARE(object["ridge"].get<float>(), 0.5F); // kept, though it counts for nothing now
        QVERIFY(!object.contains("flag"));            // it is as it begins
    }

    void keepsWhatIsNotKnownWithinIt()
    {
        const nlohmann::json parsed =
            nlohmann::json::parse(R"({"flag": {"stripes": 3, "fringe": true}})");
        Shelter read;
        Message problem;
        JsonFields source(parsed, "shelter", problem);
        readFields(source, fieldsOf<Shelter>(), &read);
        QVERIFY(source.isSound() && source.unknown().empty());
        nlohmann::json again = nlohmann::json::object();
        addFields(again, fieldsOf<Shelter>(), &read);
        QVERIFY(again["flag"] == parsed["flag"]);
    }

    void refusesInJsonWhatNoMemberMayHave()
    {
        for (const char* text : {R"({"glass": "golden"})", R"({"bulbs": 13})", R"({"watts": "x"})",
                                 R"({"flicker": [1, 0]})", R"({"leaning": [0, 0, 0, 9]})",
                                 R"({"pole": {"height": 10}})"}) {
            const nlohmann::json parsed = nlohmann::json::parse(text);
            Lantern read;
            Message problem;
            JsonFields source(parsed, "lantern", problem);
            readFields(source, fieldsOf<Lantern>(), &read);
            QVERIFY2(!source.isSound(), text);
            QVERIFY2(read == Lantern(), text);
        }
    }

    void isRecordedAsPythonThatMakesItTheSame()
    {
        const Lantern was;
        const Lantern now = changedLantern();
        QCOMPARE(app::fieldChanges(fieldsOf<Lantern>(), &was, &was, "lantern"), std::string());
        const std::string script = app::fieldChanges(fieldsOf<Lantern>(), &was, &now, "lantern");
        QCOMPARE(std::ranges::count(script, '\n'), 19); // one of each, and none of what is computed

        const app::py::object lantern = app::py::cast(was);
        app::py::dict names;
        names["crowdbrush"] = app::py::module_::import("crowdbrush");
        names["lantern"] = lantern;
        app::py::exec(script, names);
        QVERIFY(lantern.cast<const Lantern&>() == now);
    }

    void isReadByPython()
    {
        app::py::dict names;
        names["lantern"] = app::py::cast(changedLantern());
        app::py::exec(R"(
assert lantern.is_lit is True
assert lantern.bulbs == 7
assert lantern.glass == "coloured"
assert abs(lantern.watts - 60.1) < 1e-5
assert lantern.price == 1.0 / 3.0
assert tuple(lantern.color) == (1, 2, 3)
assert tuple(lantern.shade) == (4, 5, 6, 7)
assert list(lantern.leaning) == [0.5, 0.5, -0.5, 0.5]
assert lantern.hangs is True
assert lantern.is_wanted is False
assert lantern.hours == [7, 22, 23]
assert lantern.dances == {"waltz": 2.0, "tango": 0.5}
assert lantern.guests == {3: 1.5, 9: 0.25}
lantern.pole.height = 5.0
assert lantern.pole.height == 5.0
)",
                      names);
    }

    void refusesInPythonWhatNoMemberMayHave_data()
    {
        QTest::addColumn<QString>("assignment");
        QTest::newRow("a choice that there is none of") << "lantern.glass = 'golden'";
        QTest::newRow("too many") << "lantern.bulbs = 13";
        QTest::newRow("a negative weight") << "lantern.dances = {'waltz': -1}";
        QTest::newRow("another type") << "lantern.price = 'much'";
        QTest::newRow("a colour of four") << "lantern.color = (1, 2, 3, 4)";
    }
    void refusesInPythonWhatNoMemberMayHave()
    {
        QFETCH(const QString, assignment);
        const app::py::object lantern = app::py::cast(Lantern());
        app::py::dict names;
        names["lantern"] = lantern;
        QVERIFY_THROWS_EXCEPTION(app::py::error_already_set,
                                 app::py::exec(assignment.toStdString(), names));
        QVERIFY(lantern.cast<const Lantern&>() == Lantern());
    }

    void hasControlsInAForm_data()
    {
        QTest::addColumn<QString>("key");
        for (const FieldInfo& each : fieldsOf<Lantern>()) {
            // What has panels of its own rather than a row: colours, templates.
            if (*each.meta.label != '\0' && !each.is<Tint>() &&
                !each.is<std::vector<PaintColor>>() && !each.is<std::vector<TemplateWeight>>()) {
                QTest::newRow(each.meta.key) << QString::fromUtf8(each.meta.key);
            }
        }
    }
    void hasControlsInAForm()
    {
        QFETCH(const QString, key);
        const LanternForm form(&fieldNamed(key.toUtf8().constData()));
        QVERIFY(!form.isEmpty());
    }

    void isSetByItsControls()
    {
        LanternForm form;
        form.control<QCheckBox>(0).click();
        QCOMPARE(form.lantern.isLit, true);
        Q_EMIT form.control<QComboBox>(0).activated(1);
        QCOMPARE(form.lantern.glass, Glass::Frosted);
        Q_EMIT form.control<widgets::RangeSlider>().valueEdited({0.0F, 1.0F});
        QCOMPARE(form.lantern.flicker.high, 1.0F);
        auto& maker = form.control<QLineEdit>(0);
        maker.setText(QStringLiteral("Braun"));
        Q_EMIT maker.textEdited(maker.text());
        QCOMPARE(form.lantern.maker, std::string("Braun"));
        Q_EMIT form.control<widgets::ClipMix>().edited({"tango", 3.0F});
        QCOMPARE(form.lantern.dances.size(), std::size_t{1});
        auto& curve = form.control<widgets::CurveEditor>();
        curve.setCurve(changedLantern().glow);
        Q_EMIT curve.edited();
        QVERIFY(form.lantern.glow == changedLantern().glow);
    }

    void numbersAreSetBySliders_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<double>("shown");
        QTest::newRow("whole number") << "bulbs" << 3.0;
        QTest::newRow("float") << "watts" << 12.0;
        QTest::newRow("double") << "price" << 0.75;
        QTest::newRow("computed") << "all_watts" << 80.0;
    }
    void numbersAreSetBySliders()
    {
        QFETCH(const QString, key);
        QFETCH(const double, shown);
        const FieldInfo& field = fieldNamed(key.toUtf8().constData());
        LanternForm form(&field);
        Q_EMIT form.control<widgets::ValueSlider>().valueEdited(shown);
        const double now = std::visit(
            [](const auto& value) {
                if constexpr (std::is_arithmetic_v<std::decay_t<decltype(value)>>) {
                    return static_cast<double>(value);
                } else {
                    return -1.0;
                }
            },
            field.get(&form.lantern));
        QCOMPARE(now, shown);
    }

    void limitsHoldForAllMembers()
    {
        Lantern lantern = changedLantern();
        const auto sound = checkFields(fieldsOf<Lantern>(), &lantern, "lantern.");
        QVERIFY2(sound, sound ? "" : sound.error().message.c_str());
        lantern.pole.height = 10.0F;
        const auto checked = checkFields(fieldsOf<Lantern>(), &lantern, "lantern.");
        QVERIFY(!checked);
        QVERIFY(checked.error().message.starts_with("lantern.pole.height"));
    }

private:
    std::unique_ptr<app::EmbeddedPython> m_python;
};

CROWD_WINDOW_TEST(tst_DescribedStruct)
#include "tst_DescribedStruct.moc"
