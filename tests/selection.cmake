# Read by ctest after the tests are known: which run alone, and which the quick selection holds. A name that no test has
# is passed over.

# They measure the load of an idle window, or whether frames come in time.
set(PILEUS_SERIAL
  ui.Session.AFinishedPictureCostsNothing
  ui.TimelineWindow.PlaysInRealTimeAndStops
  ui.Window.RestsWithTheDefaultPreset)
set_tests_properties(${PILEUS_SERIAL} PROPERTIES RUN_SERIAL TRUE)

# Every label, in less than a minute: of the unit tests all but those that take more than 0.2 s.
set(PILEUS_QUICK
  gpu.ClosedForms.HomogeneousBoxIsExact
  gpu.ClosedForms.TwoBoxesHaveTheirSeries
  gpu.ColorGpu.ShortAndCubicLutsEqualTheirCpuTwins
  gpu.Display.GainViewAndGammaInThatOrder
  gpu.Layers.LightsAddUpToThePicture
  cli.Check.AGoodFileIsOk
  cli.Check.EveryFaultOfEveryFileIsPrinted
  cli.Check.WhatARenderNeedsIsAnErrorAndTheRestAWarning
  ui.Parameters.TypingUnitsArrowsAndEscape)
set(slow
  RandomActions
  Cloud.EveryCornerOfTheParametersWorks
  Cloud.CoverageIsTheCoveredPartOfTheGround
  Cloud.EqualParametersGiveEqualVoxels
  Cloud.ALowResolutionIsTheLowPassOfAHighOne
  Exr.MutatedFilesNeverCrash
  Exr.EveryTruncationIsAnError
  History.IsBoundedInStepsAndBytes
  BrickBuilder.RefusesAbsurdSizesAndSingularTransforms
  BrickBuilder.ContentKeyFollowsTheVoxelsAndThreadsDoNotMatter
  BrickStore.DamageIsNoticed
  VdbImport.AStreamedFileIsReadAndItsTruncationNoticed
  VdbImport.ASecondImportNeedsNoChildAndADamagedCacheIsRepaired
  VdbImport.AbsurdExtentsAreRefusedQuickly
  VdbImport.ChoosesByNameAndClass
  VdbImport.OtherScalarTypesAndActiveTiles
  Document.UndoesTenThousandRandomEdits
  Evaluator.CloudsComeCoarseFirst
  FireFit.SmokeInFrontMakesItStronger
  Recovery.KeepsTenReadOnlyFiles
  Recovery.WritesAfterARestAndOnlyThen)
list(APPEND PILEUS_QUICK ${unit_tests_TESTS})
list(JOIN slow "|" slow)
string(REPLACE "." "\\." slow "${slow}")
list(FILTER PILEUS_QUICK EXCLUDE REGEX "^unit\\.(${slow})")
set_tests_properties(${PILEUS_QUICK} PROPERTIES LABELS quick)
