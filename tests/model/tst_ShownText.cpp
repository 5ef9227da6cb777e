// SPDX-License-Identifier: MIT
#include "model/base/ShownText.h"

#include <nlohmann/json.hpp>

#include <QtTest/QTest>

#include "model/base/Message.h"
#include "model/brush/BrushJson.h"
#include "model/project/ProjectReader.h"
#include "tests/program/Test.h"

using namespace crowd::model;

/// What files and scripts hold, on its way into messages.
class ShownTextTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void longTextsKeepBeginAndEnd();
    void bytesThatAreNoTextAreReplaced_data();
    void bytesThatAreNoTextAreReplaced();
    void messagesAreAlwaysText();
    void longNamesOfFilesAreShortInMessages();
};

void ShownTextTest::longTextsKeepBeginAndEnd()
{
    QCOMPARE(shortened("short"), std::string("short"));
    QCOMPARE(shortened(std::string(80, 'x')), std::string(80, 'x'));
    QCOMPARE(shortened("abcdefghijklmnop", 8), std::string("abcde…op"));
    QCOMPARE(shortened("äöüäöüäöüä", 8), std::string("äöüäö…üä"));
    QCOMPARE(QString::fromStdString(shortened(std::string(5000, 'x'))).size(), qsizetype{80});
}

void ShownTextTest::bytesThatAreNoTextAreReplaced_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QByteArray>("text");
    const auto row = [](const char* name, const QByteArray& bytes, const QByteArray& text) {
        QTest::newRow(name) << bytes << text;
    };
    const QByteArray mark("\xEF\xBF\xBD");
    row("nothing", "", "");
    row("a text", "Größe …😀", "Größe …😀");
    row("a byte that is none", "a\xff z", "a" + mark + " z");
    row("at the begin", "\xff", mark);
    row("a character cut short", "a\xE2\x80", "a" + mark + mark);
    row("one too long for what it says", "\xC0\x80", mark + mark);
    row("half of a pair", "\xED\xA0\x80", mark + mark + mark);
    row("beyond Unicode", "\xF4\x90\x80\x80!", mark + mark + mark + mark + "!");
}

void ShownTextTest::bytesThatAreNoTextAreReplaced()
{
    QFETCH(const QByteArray, bytes);
    QFETCH(const QByteArray, text);
    QCOMPARE(wellFormed(bytes.toStdString()), text.toStdString());
}

void ShownTextTest::messagesAreAlwaysText()
{
    const Message message("The file %1 cannot be read.", std::string("\xff.glb"));
    QCOMPARE(message.english(), std::string("The file \xEF\xBF\xBD.glb cannot be read."));
}

void ShownTextTest::longNamesOfFilesAreShortInMessages()
{
    constexpr std::size_t kShort = 1000;
    const std::string name(5000, 'm');
    const auto brush = brushFromJson({{"brush", "scale"}, {name, 1}});
    QVERIFY(!brush);
    QVERIFY(brush.error().message.find("brush has no \"mmm") != std::string::npos);
    QVERIFY(brush.error().message.size() < kShort);
    const std::string scene = R"({"format": "crowdbrush-scene", "version": 1, )";
    for (const std::string& rest : {'"' + name + "\": 1, \"" + name + "\": 2}", // twice
                                    R"("individuals": {"columns": ["id", ")" + name + R"(", ")" +
                                        name + R"("], "rows": []}})",
                                    '"' + name}) {
        const auto read = projectFromText(scene + rest);
        QVERIFY(!read);
        QVERIFY2(read.error().message.size() < kShort, read.error().message.c_str());
    }
}

CROWD_TEST(ShownTextTest)
#include "tst_ShownText.moc"
