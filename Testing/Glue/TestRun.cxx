#include "Glue/Run.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

// With each backend, the exception of the lowest index reaches the caller.
TEST(Run, ThrowsExceptionsOfThreadsAgain)
{
  for (const char* backend : { "Sequential", "STDThread", "TBB" })
  {
    std::string message;
    const auto fail = [&]()
    {
      conformal::forBlocks(glue::SMPRun(), 1000, 1,
        [](conformal::Index begin, conformal::Index)
        {
          if (begin % 100 == 7)
          {
            throw std::runtime_error(std::to_string(begin));
          }
        });
    };
    vtkSMPTools::LocalScope(vtkSMPTools::Config(4, backend, false),
      [&]()
      {
        try
        {
          fail();
        }
        catch (const std::runtime_error& error)
        {
          message = error.what();
        }
      });
    EXPECT_EQ(message, "7") << backend;
  }
}
