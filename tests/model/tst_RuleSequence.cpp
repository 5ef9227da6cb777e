// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include "model/base/Random.h"
#include "model/rules/RuleSequence.h"
#include "tests/program/Test.h"

using namespace crowd::model;

namespace {

/// "a b{ c d } e": letters are lines, braces what belongs to the Repeat before; "<" and "|" and ">"
/// the alternatives of a choice, which are lines without a letter.
Actions linesOf(const char* text)
{
    Actions actions;
    std::uint8_t depth = 0;
    const auto add = [&](Action action, char name) {
        action.depth = depth;
        action.unknownMembers = name;
        actions.push_back(action);
    };
    for (const char* c = text; *c != 0; ++c) {
        if (*c == '{') {
            actions.back().data = actions::Repeat();
            ++depth;
        } else if (*c == '}' || *c == '>') {
            --depth;
        } else if (*c == '<' || *c == '|') {
            depth = static_cast<std::uint8_t>(depth - (*c == '|' ? 1 : 0));
            add(actions::OneOf(), '?');
            ++depth;
        } else if (*c != ' ') {
            add(actions::Wait(), *c);
        }
    }
    return actions;
}

std::size_t lineOf(const Actions& actions, char name)
{
    const auto found = std::ranges::find(actions, std::string(1, name), &Action::unknownMembers);
    return static_cast<std::size_t>(found - actions.begin());
}

QString outlineOf(const Actions& actions)
{
    QString text;
    for (const Action& action : actions) {
        text +=
            QString(action.depth, QLatin1Char('.')) + QString::fromStdString(action.unknownMembers);
    }
    return text;
}

} // namespace

class TestRuleSequence : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void linesKnowWhatBelongsToThem();
    void linesMove_data();
    void linesMove();
    void whatIsRemovedTakesItsLinesAlong();
    void linesAreAddedInsideAndBeside();
    void depthsSettle();
    void movesNeverLoseALine();
};

void TestRuleSequence::linesKnowWhatBelongsToThem()
{
    const Actions actions = linesOf("a b{ c < d | e > } f");
    QCOMPARE(outlineOf(actions), QStringLiteral("ab.c.?..d.?..ef"));
    QCOMPARE(endOf(actions, 1), std::size_t{7});
    QCOMPARE(endOf(actions, 3), std::size_t{5});
    QCOMPARE(parentOf(actions, 4), std::size_t{3});
    QCOMPARE(parentOf(actions, 3), std::size_t{1});
    QCOMPARE(parentOf(actions, 7), kNoLine);
    const std::vector<std::size_t> both{3, 5};
    QCOMPARE(alternativesOf(actions, 3), both);
    QCOMPARE(alternativesOf(actions, 5), both);
}

void TestRuleSequence::linesMove_data()
{
    QTest::addColumn<QString>("before");
    QTest::addColumn<QString>("line");
    QTest::addColumn<bool>("isUp");
    QTest::addColumn<QString>("after");
    const auto row = [](const char* name, const char* before, const char* line, bool isUp,
                        const char* after) {
        QTest::newRow(name) << before << line << isUp << outlineOf(linesOf(after));
    };
    row("up past another", "a b c", "b", true, "b a c");
    row("down past another", "a b c", "b", false, "a c b");
    row("the first stays", "a b", "a", true, "a b");
    row("the last stays", "a b", "b", false, "a b");
    row("up into a repeat", "a{ b } c", "c", true, "a{ b c }");
    row("up out of a repeat", "a{ b c }", "b", true, "b a{ c }");
    row("down into a repeat", "a b{ c }", "a", false, "b{ a c }");
    row("down out of a repeat", "a{ b c } d", "c", false, "a{ b } c d");
    row("a repeat with all in it, up", "a b{ c d }", "b", true, "b{ c d } a");
    row("a repeat with all in it, down", "b{ c d } a e", "b", false, "a b{ c d } e");
    row("a repeat into another", "a{ b } c{ d }", "c", true, "a{ b c{ d } }");
    row("up into the last alternative", "< a | b > c", "c", true, "< a | b c >");
    row("up from one alternative to the other", "< a | b c >", "b", true, "< a b | c >");
    row("down from one alternative to the other", "< a | b c >", "a", false, "< | a b c >");
    row("down out of the last alternative", "< a | b >", "b", false, "< a | > b");
}

void TestRuleSequence::linesMove()
{
    QFETCH(QString, before);
    QFETCH(QString, line);
    QFETCH(bool, isUp);
    QFETCH(QString, after);
    Actions actions = linesOf(before.toUtf8().constData());
    (isUp ? moveUp : moveDown)(actions, lineOf(actions, line.at(0).toLatin1()));
    QCOMPARE(outlineOf(actions), after);
}

void TestRuleSequence::whatIsRemovedTakesItsLinesAlong()
{
    Actions actions = linesOf("a b{ c d{ e } } f");
    removeLine(actions, 1);
    QCOMPARE(outlineOf(actions), outlineOf(linesOf("a f")));
    actions = linesOf("< a | b >");
    removeLine(actions, 0);
    QCOMPARE(outlineOf(actions), outlineOf(linesOf("< b >")));
}

void TestRuleSequence::linesAreAddedInsideAndBeside()
{
    Actions actions = linesOf("a{ b } c");
    Action added;
    added.unknownMembers = "x";
    addInside(actions, 0, added);
    QCOMPARE(outlineOf(actions), outlineOf(linesOf("a{ b x } c")));
    actions = linesOf("< a | b > c");
    addAlternative(actions, 0);
    QCOMPARE(actions.size(), std::size_t{6});
    QVERIFY(actions[4].is<actions::OneOf>() && actions[4].depth == 0);
    QCOMPARE(alternativesOf(actions, 0).size(), std::size_t{3});
}

void TestRuleSequence::depthsSettle()
{
    Actions actions = linesOf("a b c d");
    actions[0].depth = 5;
    actions[1].data = actions::Repeat();
    actions[2].depth = 200;
    actions[3].depth = 2;
    settleDepths(actions);
    QCOMPARE(outlineOf(actions), QStringLiteral("ab.c.d"));
}

/// Whatever is done to them, all lines are there and none is deeper than it can be.
void TestRuleSequence::movesNeverLoseALine()
{
    Actions actions = linesOf("a b{ c < d | e f | g > h } i{ j } < k | l{ m } >");
    QString names = outlineOf(actions).remove(QLatin1Char('.'));
    std::sort(names.begin(), names.end());
    for (std::uint64_t turn = 0; turn < 5000; ++turn) {
        const std::size_t line = hashKeys(7, turn, 1) % actions.size();
        ((hashKeys(7, turn, 2) & 1U) != 0 ? moveUp : moveDown)(actions, line);
        QString now = outlineOf(actions).remove(QLatin1Char('.'));
        std::sort(now.begin(), now.end());
        QCOMPARE(now, names);
        Actions settled = actions;
        settleDepths(settled);
        QCOMPARE(outlineOf(settled), outlineOf(actions));
    }
}

CROWD_TEST(TestRuleSequence)
#include "tst_RuleSequence.moc"
