// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QCoreApplication>
#include <QtTest/QTest>

/// One program holds the tests of a room, so that a room is linked once:
///
///     build/release/tests/test_model tst_Bake [Qt Test's own arguments]
///
/// Every tst_*.cpp registers its class with CROWD_TEST, or CROWD_WINDOW_TEST from WindowTest.h.
namespace crowd::tests {

using TestRun = int (*)(int argc, char** argv);

/// Names the test after its file; called before main.
bool addTest(const char* file, TestRun run);

template<class Test>
int runTest(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    Test test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace crowd::tests

#define CROWD_ADD_TEST(Class, run)                                                                 \
    namespace {                                                                                    \
    [[maybe_unused]] const bool isAdded##Class = crowd::tests::addTest(__FILE__, run<Class>);      \
    }

#define CROWD_TEST(Class) CROWD_ADD_TEST(Class, crowd::tests::runTest)
