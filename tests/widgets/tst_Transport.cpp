// SPDX-License-Identifier: MIT
#include <cmath>

#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

#include "tests/program/Test.h"
#include "widgets/state/Transport.h"

using crowd::widgets::Transport;

class TestTransport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void playsFromTheStart();
    void standsStillWhilePaused();
    void runsAtItsSpeed();
    void takesALongPauseOfTheWindowAsAShortStep();
    void slowPicturesTakeNoTimeAway();
    void saysHowMuchOfItsSpeedItKeeps();
    void rewindsAndSaysSo();
    void boundsWhatItIsGiven();
};

void TestTransport::playsFromTheStart()
{
    Transport transport;
    QVERIFY(transport.isPlaying());
    QCOMPARE(transport.seconds(), 0.0);
    transport.advance(0.1);
    QCOMPARE(transport.seconds(), 0.1);
}

void TestTransport::standsStillWhilePaused()
{
    Transport transport;
    QSignalSpy states(&transport, &Transport::stateChanged);
    transport.toggle();
    QSignalSpy times(&transport, &Transport::timeChanged);
    transport.advance(0.1);
    QCOMPARE(transport.seconds(), 0.0);
    QCOMPARE(times.count(), 0);
    transport.setPlaying(false);
    QCOMPARE(states.count(), 1);
    transport.toggle();
    transport.advance(0.1);
    QCOMPARE(transport.seconds(), 0.1);
    QCOMPARE(times.count(), 1);
}

void TestTransport::runsAtItsSpeed()
{
    Transport transport;
    transport.setSpeed(0.5);
    transport.advance(0.2);
    QCOMPARE(transport.seconds(), 0.1);
}

void TestTransport::takesALongPauseOfTheWindowAsAShortStep()
{
    Transport transport;
    transport.advance(30.0);
    QCOMPARE(transport.seconds(), 2.0);
    transport.advance(-1.0);
    QCOMPARE(transport.seconds(), 2.0);
}

void TestTransport::slowPicturesTakeNoTimeAway()
{
    Transport transport;
    for (int picture = 0; picture < 40; ++picture) {
        transport.advance(0.5);
    }
    QCOMPARE(transport.seconds(), 20.0);
    QCOMPARE(transport.pace(), 1.0);
}

void TestTransport::saysHowMuchOfItsSpeedItKeeps()
{
    Transport transport;
    transport.setSpeed(2.0);
    for (int picture = 0; picture < 20; ++picture) {
        transport.advance(0.5, transport.seconds() + 0.25); // a quarter of what is wanted
    }
    QVERIFY(std::abs(transport.pace() - 0.25) < 0.01);
    transport.toggle();
    transport.toggle();
    QCOMPARE(transport.pace(), 1.0);
}

void TestTransport::rewindsAndSaysSo()
{
    Transport transport;
    transport.advance(0.2);
    QSignalSpy states(&transport, &Transport::stateChanged);
    transport.rewind();
    QCOMPARE(transport.seconds(), 0.0);
    QVERIFY(transport.isPlaying());
    QCOMPARE(states.count(), 1);
    transport.rewind();
    QCOMPARE(states.count(), 1);
}

void TestTransport::boundsWhatItIsGiven()
{
    Transport transport;
    transport.setSeconds(-3.0);
    QCOMPARE(transport.seconds(), 0.0);
    transport.setSpeed(1000.0);
    QCOMPARE(transport.state().speed, 8.0);
    transport.setSpeed(0.0);
    QCOMPARE(transport.state().speed, 0.05);
}

CROWD_TEST(TestTransport)
#include "tst_Transport.moc"
