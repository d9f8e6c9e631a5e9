# Filled in with the install and export rules.
