crowd_add_tests(ROOM behavior LINK crowd_behavior TESTS
    tst_CrowdSimulation
    tst_FootSlide
    tst_Problems
    tst_RuleActions
    tst_RuleAims
    tst_RuleLooks
    tst_RuleSequences
    tst_Rules
    tst_Session
    tst_SessionPlayer
    tst_SessionSteps
    tst_StrideKernel
    tst_Validation
    tst_WalkSurface
)
