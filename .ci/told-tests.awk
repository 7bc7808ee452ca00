# Shows what tests tell, without what those that passed have printed, and counts them in the last line: those too
# that were skipped because the corpus, the ledger or another program is not on this computer. Names those that failed before it.
/^successes:$/ { quiet = 1 }
/^test result:/ { quiet = 0; passed += $4; failed += $6 }
/^failures:$/ { quiet = 0 }
/^skipped: / { skipped += 1; print; next }
/^test .* \.\.\. FAILED$/ { names = names "failed: " $2 "\n" }
!quiet { print; fflush() }
END { printf "%s", names; printf "rust tests: %d passed, %d of them skipped, %d failed\n", passed, skipped, failed }
