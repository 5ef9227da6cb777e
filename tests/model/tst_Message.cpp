// SPDX-License-Identifier: MIT
#include "model/base/Message.h"

#include <map>
#include <thread>
#include <vector>

#include <QtTest/QTest>

#include "model/base/Result.h"
#include "tests/program/Test.h"

using namespace crowd::model;

namespace {

/// A language of which few words are known.
std::string inGerman(const char* id)
{
    static const std::map<std::string, std::string> words{
        {"%1 must lie between %2 and %3", "Zwischen %2 und %3 muss %1 liegen"},
        {"it is empty", "sie ist leer"},
        {"The file %1 cannot be read: %2.", "Die Datei %1 ist unlesbar: %2."},
        {"unfinished", ""},
    };
    const auto found = words.find(id);
    return found == words.end() ? std::string(id) : found->second;
}

} // namespace

/// Messages with an id and arguments, in English and in another language.
class MessageTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void argumentsGoWhereTheTranslationWantsThem();
    void messagesInMessagesAreTranslatedToo();
    void whatOthersSaidStaysAsItIs();
    void whatIsNotTranslatedIsEnglish();
    void percentSignsOfArgumentsAreNoPlaces();
    void numbersAreAsShortAsReadsBackTheSame();
    void anErrorIsEnglishForScripts();
    void copiesAreReadByManyThreads();
};

void MessageTest::argumentsGoWhereTheTranslationWantsThem()
{
    const Message message("%1 must lie between %2 and %3", "speed", 1, 2.5F);
    QCOMPARE(message.english(), std::string("speed must lie between 1 and 2.5"));
    QCOMPARE(message.in(&inGerman), std::string("Zwischen 1 und 2.5 muss speed liegen"));
}

void MessageTest::messagesInMessagesAreTranslatedToo()
{
    const Message message("The file %1 cannot be read: %2.", std::string("a.glb"),
                          Message("it is empty"));
    QCOMPARE(message.english(), std::string("The file a.glb cannot be read: it is empty."));
    QCOMPARE(message.in(&inGerman), std::string("Die Datei a.glb ist unlesbar: sie ist leer."));
}

void MessageTest::whatOthersSaidStaysAsItIs()
{
    const Message message("The file %1 cannot be read: %2.", "a.glb", "it is empty");
    QCOMPARE(message.in(&inGerman), std::string("Die Datei a.glb ist unlesbar: it is empty."));
    QCOMPARE(Message(std::string("it is empty")).in(&inGerman), std::string("it is empty"));
    QVERIFY(Message(std::string()).empty());
    QVERIFY(Message().english().empty());
}

void MessageTest::whatIsNotTranslatedIsEnglish()
{
    QCOMPARE(Message("unfinished").in(&inGerman), std::string("unfinished"));
    QCOMPARE(Message("%1 is unheard of", 7).in(&inGerman), std::string("7 is unheard of"));
}

void MessageTest::percentSignsOfArgumentsAreNoPlaces()
{
    const Message message("%1 must lie between %2 and %3", "%2%3", "%1", "100 %");
    QCOMPARE(message.english(), std::string("%2%3 must lie between %1 and 100 %"));
    QCOMPARE(Message("%1 of 50 %, %9 and %0", 3).english(), std::string("3 of 50 %, %9 and %0"));
}

void MessageTest::numbersAreAsShortAsReadsBackTheSame()
{
    QCOMPARE(Message("%1", 0.1F).english(), std::string("0.1"));
    QCOMPARE(Message("%1", 0.1).english(), std::string("0.1"));
    QCOMPARE(Message("%1", 1e-7).english(), std::string("1e-07"));
    QCOMPARE(Message("%1", std::size_t{4'000'000'000}).english(), std::string("4000000000"));
    QCOMPARE(Message("%1", std::uint8_t{65}).english(), std::string("65"));
}

void MessageTest::anErrorIsEnglishForScripts()
{
    const Error error{"The file %1 cannot be read: %2.", "a.glb", Message("it is empty")};
    QCOMPARE(error.message, std::string("The file a.glb cannot be read: it is empty."));
    QCOMPARE(error.said.in(&inGerman), std::string("Die Datei a.glb ist unlesbar: sie ist leer."));
    QVERIFY(Error(std::string("it is empty")).said == Message("it is empty"));
}

void MessageTest::copiesAreReadByManyThreads()
{
    std::vector<std::string> said(8);
    {
        const Message message("The file %1 cannot be read: %2.", "a.glb", Message("it is empty"));
        std::vector<std::jthread> threads;
        for (std::string& each : said) {
            threads.emplace_back([message, &each] {
                for (int i = 0; i < 100; ++i) {
                    const Message copy = message;
                    each = copy.in(&inGerman);
                }
            });
        }
    }
    for (const std::string& each : said) {
        QCOMPARE(each, std::string("Die Datei a.glb ist unlesbar: sie ist leer."));
    }
}

CROWD_TEST(MessageTest)
#include "tst_Message.moc"
