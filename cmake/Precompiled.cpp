// The precompiled headers need a file of their own.
